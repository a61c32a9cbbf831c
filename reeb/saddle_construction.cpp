// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/saddle_construction.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"
#include "reeb/band_count.h"
#include "reeb/contour_touches.h"
#include "reeb/critical_bouquet.h"
#include "reeb/guiding_curve.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

using Kind = StrandEnd::Kind;

class SaddleBuilder {
 public:
    SaddleBuilder(const NamedNode& node, const SurfaceOptions& options, std::vector<Strand>& strands,
                  BandSurface& surface)
        : node_(node), options_(options), strands_(strands), surface_(surface) {}

    //! Do contours through a saddle say how they run together there?
    bool is_given(const NodeSide& side) const {
        std::ptrdiff_t visits = 0;
        for (const std::uint32_t e : side.edges) {
            const auto own = std::ranges::count(end_contour(strands_, side, e).points, node_.place);
            if (own == 0) return false;
            visits += own;
        }
        return visits > 1;
    }

    //! Contours of one side run to the critical point; those of the other are what they become there. Where more than two can't
    //! all reach one point without crossing, they touch across the gaps between them instead, at that height.
    void run(const NodeSide& given, const NodeSide& across) {
        const Point3& critical = node_.place;
        const bool through = is_given(given);
        if (!through) shorten_sides(given);
        shorten_sides(across);
        std::vector<std::vector<TouchedPlace>> places;
        for (const std::uint32_t e : given.edges)
            places.push_back(
                {{through ? 0 : nearest_parameter(end_contour(strands_, given, e), critical), critical}});
        const std::size_t points_before = surface_.points().size();
        auto curves = lead_together(given, places, through);
        if (!through && given.edges.size() > 2 && (!curves || curves->size() != across.edges.size())) {
            surface_.drop_points_from(points_before);
            curves = lead_together(given, gaps_between(given, critical.z), false);
        }
        if (!curves || curves->size() != across.edges.size())
            throw InvalidInput(fmt::format(
                "{}: the {} contours {} it make {} there, not the {} {} it; move the node between them, or "
                "give contours at its height that pass through it",
                node_.name, given.edges.size(), given.is_lower ? "below" : "above",
                curves ? curves->size() : 0, across.edges.size(), given.is_lower ? "above" : "below"));
        assign(*curves, critical, across);
    }

 private:
    //! Corners alone are too few to bend towards the critical point.
    void shorten_sides(const NodeSide& side) {
        for (const std::uint32_t e : side.edges) {
            SampledContour& contour = end_contour(strands_, side, e);
            contour =
                with_short_sides(contour, perimeter(contour.points) / static_cast<double>(options_.samples));
        }
    }

    std::vector<std::vector<TouchedPlace>> gaps_between(const NodeSide& side, double height) {
        std::vector<SampledContour> contours;
        for (const std::uint32_t e : side.edges) contours.push_back(end_contour(strands_, side, e));
        std::vector<std::vector<TouchedPlace>> places(contours.size());
        for (const ContourTouch& touch : contour_touches(contours, height)) {
            places[touch.first].push_back({touch.first_parameter, touch.place});
            places[touch.second].push_back({touch.second_parameter, touch.place});
        }
        return places;
    }

    using Vertices = std::map<std::tuple<double, double, double>, std::uint32_t>;

    //! Lead contours to places of their own; what they are on the far side.
    std::optional<std::vector<PointLoop>> lead_together(const NodeSide& side,
                                                        const std::vector<std::vector<TouchedPlace>>& places,
                                                        bool through) {
        Vertices vertices;  // by place
        std::set<std::uint32_t> critical;
        for (const auto& own : places)
            for (const auto& [parameter, p] : own) {
                const auto [at, is_new] = vertices.try_emplace({p.x, p.y, p.z}, 0);
                if (is_new) at->second = surface_.add_point(p);
                critical.insert(at->second);
            }
        std::vector<PointLoop> loops;
        std::vector<bool> is_hole;
        std::vector<std::vector<Point2>> outlines;
        for (std::size_t i = 0; i < side.edges.size(); ++i) {
            StrandEnd& strand_end = end_of(strands_, side, side.edges[i]);
            lead_to(strand_end, end_contour(strands_, side, side.edges[i]), places[i], through, vertices);
            loops.push_back(strand_end.ring->vertices);
            is_hole.push_back(strands_[side.edges[i]].is_hole);
            outlines.emplace_back();
            for (const Point3& p : strand_end.ring->shape.points) outlines.back().push_back({p.x, p.y});
        }
        if (side.edges.size() > 2 && !ring_crossings(outlines, {.shared_corners = true, .most = 1}).empty())
            return std::nullopt;
        return contours_across(loops, is_hole, critical, surface_.points());
    }

    void lead_to(StrandEnd& strand_end, SampledContour shape, const std::vector<TouchedPlace>& places,
                 bool through, const Vertices& vertices) {
        strand_end.kind = through ? Kind::Through : Kind::Approach;
        strand_end.approach.clear();
        if (!through) {
            double gap = 0;
            for (const auto& [parameter, place] : places)
                gap = std::max(gap, magnitude(place - point_at(shape, parameter)));
            const std::size_t steps =
                bands_across(gap, point_spacing(shape.points), options_.steps, 1, options_.steps);
            for (std::size_t k = 1; k < steps; ++k)
                strand_end.approach.push_back(approach_places(
                    shape, places, static_cast<double>(k) / static_cast<double>(steps), options_.reach));
            shape = approach_places(shape, places, 1, options_.reach);
        }
        Ring ring{shape, {}};
        for (const Point3& p : shape.points) {
            const auto known = vertices.find({p.x, p.y, p.z});
            ring.vertices.push_back(known != vertices.end() ? known->second : surface_.add_point(p));
            if (!through && known == vertices.end())
                surface_.let_free(ring.vertices.back(), Freedom::Space, strand_end.group);
        }
        strand_end.ring = std::move(ring);
    }

    //! Each curve to the edge whose contour is nearest, the nearest pair first.
    void assign(const std::vector<PointLoop>& curves, const Point3& critical, const NodeSide& side) {
        struct Match {
            double distance;
            std::size_t curve;
            std::uint32_t edge;
        };
        std::vector<Match> matches;
        for (std::size_t c = 0; c < curves.size(); ++c)
            for (const std::uint32_t e : side.edges)
                matches.push_back({distance(curves[c], end_contour(strands_, side, e)), c, e});
        std::ranges::stable_sort(matches, {}, &Match::distance);
        std::vector<bool> used(curves.size(), false);
        for (const Match& match : matches) {
            StrandEnd& strand_end = end_of(strands_, side, match.edge);
            if (used[match.curve] || strand_end.ring) continue;
            used[match.curve] = true;
            std::vector<Point3> points;
            for (const std::uint32_t v : curves[match.curve]) points.push_back(surface_.points()[v]);
            strand_end.kind = Kind::Ring;
            strand_end.ring = Ring{contour_by_perimeter(std::move(points)), curves[match.curve]};
            drop_contour_at(critical, side, match.edge);
        }
    }

    //! A contour of the far side at the node's own height has given way to what its neighbours make.
    void drop_contour_at(const Point3& critical, const NodeSide& side, std::uint32_t e) {
        Strand& strand = strands_[e];
        if (end_height(strands_, side, e) != critical.z || strand.contours.size() < 2) return;
        const auto at = side.is_lower ? strand.contours.size() - 1 : 0;
        strand.contours.erase(strand.contours.begin() + static_cast<std::ptrdiff_t>(at));
        strand.heights.erase(strand.heights.begin() + static_cast<std::ptrdiff_t>(at));
    }

    double distance(const PointLoop& curve, const SampledContour& contour) const {
        constexpr std::size_t kPlaces = 48;
        const std::size_t step = 1 + curve.size() / kPlaces;
        double sum = 0;
        for (std::size_t i = 0; i < curve.size(); i += step) {
            double least = std::numeric_limits<double>::max();
            for (const Point3& p : contour.points)
                least = std::min(least, magnitude(p - surface_.points()[curve[i]]));
            sum += least;
        }
        return sum;
    }

    const NamedNode& node_;
    const SurfaceOptions& options_;
    std::vector<Strand>& strands_;
    BandSurface& surface_;
};

}  // namespace

StrandEnd& end_of(std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge) {
    return side.is_lower ? strands[edge].top : strands[edge].bottom;
}

SampledContour& end_contour(std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge) {
    return side.is_lower ? strands[edge].contours.back() : strands[edge].contours.front();
}

double end_height(const std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge) {
    return side.is_lower ? strands[edge].heights.back() : strands[edge].heights.front();
}

void make_saddle(const NamedNode& node, const NodeSide& lower, const NodeSide& upper,
                 const SurfaceOptions& options, std::vector<Strand>& strands, BandSurface& surface) {
    SaddleBuilder builder(node, options, strands, surface);
    const bool from_lower =
        builder.is_given(lower) || (!builder.is_given(upper) && lower.edges.size() >= upper.edges.size());
    builder.run(from_lower ? lower : upper, from_lower ? upper : lower);
}

}  // namespace stratareeb
