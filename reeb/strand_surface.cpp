// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/strand_surface.h"

#include <algorithm>
#include <cmath>

#include "reeb/band_count.h"
#include "reeb/cap_profile.h"
#include "reeb/cap_rows.h"
#include "reeb/contour_alignment.h"
#include "reeb/contour_matching.h"
#include "reeb/height_scale.h"
#include "reeb/point_math.h"
#include "reeb/sliding_homotopy.h"

namespace stratareeb {

namespace {

using Kind = StrandEnd::Kind;

const std::vector<SampledContour> kNoRows;

constexpr double kNotLonger = 0.25;  // of the mean interval, that one may be longer without more bands
constexpr double kMostSteps = 8;     // times the bands of other intervals
constexpr std::size_t kLeastAtSaddle =
    3;                           // bands: neighbours with a ring's own parameters keep its equal points apart
constexpr double kSteepest = 2;  // rise over run of terrain, 63 degrees

//! The ring matched to a contour, with its vertices.
Ring matched_ring(const SampledContour& below, const Ring& ring, Matching matching) {
    Ring result{matched_contour(below, ring.shape, matching), ring.vertices};
    std::vector<std::uint32_t>& vertices = result.vertices;
    std::size_t shift = 0;
    const auto fits = [&](std::size_t k) {
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if (!(result.shape.points[i] == ring.shape.points[(i + k) % vertices.size()])) return false;
        return true;
    };
    while (shift < vertices.size() && !fits(shift)) ++shift;
    std::ranges::rotate(vertices, vertices.begin() + static_cast<std::ptrdiff_t>(shift % vertices.size()));
    return result;
}

double plan_area(const std::vector<Point3>& ring) {
    double twice = 0;
    const Point3& o = ring.front();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return twice / 2;
}

class StrandBuilder {
 public:
    StrandBuilder(BandSurface& surface, const Strand& strand, std::size_t steps, SheetMemory& sheets,
                  const std::function<std::uint32_t(std::size_t)>& begin_place)
        : surface_(surface),
          strand_(strand),
          steps_(std::max<std::size_t>(steps, 1)),
          sheets_(sheets),
          begin_place_(begin_place) {}

    std::size_t run() {
        collect_rings();
        align_rings();
        make_homotopy();
        begin(0);
        add_end(strand_.bottom, false);
        for (std::size_t k = 0; k + 1 < rings_.size(); ++k) {
            begin(k + 1);
            add_between(k);
        }
        begin(rings_.size());
        add_end(strand_.top, true);
        return straightened_;
    }

 private:
    void begin(std::size_t place) {
        group_ = begin_place_(place);
        const auto at = strand_.joins.find(place);
        join_ = at != strand_.joins.end() && at->second != Join::ByShape ? std::optional(at->second)
                                                                         : std::nullopt;
    }

    void collect_rings() {
        if (strand_.bottom.kind == Kind::Ring) add_ring(*strand_.bottom.ring, strand_.bottom.node.z);
        for (std::size_t k = 0; k < strand_.contours.size(); ++k) {
            const bool first = k == 0, last = k + 1 == strand_.contours.size();
            if (first && is_own_ring(strand_.bottom))
                add_ring(*strand_.bottom.ring, strand_.heights[k]);
            else if (last && is_own_ring(strand_.top))
                add_ring(*strand_.top.ring, strand_.heights[k]);
            else
                add_ring(surface_.add_ring(strand_.contours[k]), strand_.heights[k]);
        }
        if (strand_.top.kind == Kind::Ring) add_ring(*strand_.top.ring, strand_.top.node.z);
    }

    //! Does the end say what vertices the last contour has?
    static bool is_own_ring(const StrandEnd& end) {
        return end.kind == Kind::Through || end.kind == Kind::Sheet;
    }

    void add_ring(Ring ring, double height) {
        rings_.push_back(std::move(ring));
        heights_.push_back(height);
    }

    void align_rings() {
        for (std::size_t k = 1; k < rings_.size(); ++k)
            rings_[k] = matched_ring(rings_[k - 1].shape, rings_[k], matching_below(k));
    }

    //! Rings at saddles are another shape than the contours beside them: by length they come closer to what is smooth.
    Matching matching_below(std::size_t k) const {
        if (strand_.joins.contains(k)) return Matching::ByShape;
        return is_bouquet(k) || is_bouquet(k - 1) ? Matching::ByLength : Matching::Automatic;
    }

    void make_homotopy() {
        if (make_round_homotopy() || rings_.size() < 2) return;
        std::vector<SampledContour> shapes;
        for (const Ring& ring : rings_) shapes.push_back(ring.shape);
        homotopy_.emplace(std::move(shapes), heights_, strand_.homotopy);
        if (strand_.lean) lean_.emplace(*strand_.lean);
        if (lean_) sliding_.emplace(*homotopy_, *lean_);
    }

    //! Bands in an interval of the homotopy: more of them where a round one is longer than the others, which keeps chords short.
    std::size_t steps_in(std::size_t interval) const {
        if (!is_round_) return steps_;
        const auto& places = homotopy_->places();
        const double mean = (places.back() - places.front()) / static_cast<double>(homotopy_->intervals());
        const double share = (places[interval + 1] - places[interval]) / mean;
        return steps_ * static_cast<std::size_t>(std::clamp(std::ceil(share - kNotLonger), 1.0, kMostSteps));
    }

    //! Over the root of the height beside nodes, with tips as contours of one point. \return whether the strand wants that and has room
    bool make_round_homotopy() {
        if (strand_.homotopy.pace == HomotopyPace::Even || CapProfile::of(strand_.homotopy.kind))
            return false;
        std::vector<SampledContour> shapes;
        std::vector<double> heights;
        const auto add = [&](SampledContour shape, double height) {
            shapes.push_back(std::move(shape));
            heights.push_back(height);
        };
        const auto add_tip = [&](const StrandEnd& end) {
            if (end.kind == Kind::Tip) add({.points = {end.node}, .parameters = {0}}, end.node.z);
        };
        add_tip(strand_.bottom);
        for (std::size_t k = 0; k < rings_.size(); ++k) add(rings_[k].shape, heights_[k]);
        add_tip(strand_.top);
        if (shapes.size() < 2) return false;
        const HeightScale scale(strand_.bottom.node.z, strand_.top.node.z, strand_.bottom.kind != Kind::Flat,
                                strand_.top.kind != Kind::Flat);
        for (std::size_t k = 1; k < heights.size(); ++k)
            if (!(scale.place(heights[k - 1]) < scale.place(heights[k]))) return false;
        homotopy_.emplace(std::move(shapes), heights, strand_.homotopy, scale);
        is_round_ = true;
        return true;
    }

    //! Of the homotopy, between a ring and the next.
    std::size_t interval(std::size_t k) const {
        return k + (is_round_ && strand_.bottom.kind == Kind::Tip ? 1 : 0);
    }

    bool is_bouquet(std::size_t k) const {
        const bool at_bottom =
            k == 0 && (strand_.bottom.kind == Kind::Ring || strand_.bottom.kind == Kind::Through);
        const bool at_top =
            k + 1 == rings_.size() && (strand_.top.kind == Kind::Ring || strand_.top.kind == Kind::Through);
        return at_bottom || at_top;
    }

    //! A ring at a saddle has the critical point several times: neighbours with its own parameters keep these apart. The edge
    //! goes on from there to the critical point, not to the ring's centre, so nothing leans along it.
    void add_between(std::size_t k) {
        const bool at_saddle = is_bouquet(k) || is_bouquet(k + 1);
        const std::size_t most = at_saddle ? std::max(steps_, kLeastAtSaddle) : steps_in(interval(k));
        // Where something crossed, all of them.
        const std::size_t steps =
            strand_.joins.contains(k + 1)
                ? most
                : bands_across(gap_above(k), spacing_above(k), steps_, at_saddle ? kLeastAtSaddle : 1, most);
        const bool is_gentle = strand_.is_terrain && !at_saddle && is_gentle_between(k);
        if ((join_ == Join::Sheet || (!join_ && is_gentle)) &&
            add_sheet({{&rings_[k], true}, {&rings_[k + 1], false}}, std::nullopt, group_))
            return;
        if (join_) ++straightened_;
        std::vector<SampledContour> between;
        if (!join_)
            between = sliding_ && !at_saddle ? sliding_->contours_between(interval(k), steps)
                                             : homotopy_->contours_between(interval(k), steps);
        else if (at_saddle && surface_.add_sound_band(rings_[k], rings_[k + 1], strand_.is_hole))
            return;
        else if (at_saddle)
            between = ContourHomotopy({rings_[k].shape, rings_[k + 1].shape}, {heights_[k], heights_[k + 1]},
                                      {.kind = HomotopyKind::Linear})
                          .contours_between(0, steps);
        const std::uint32_t group = is_bouquet(k) ? strand_.bottom.group : strand_.top.group;
        Ring below = rings_[k];
        for (const SampledContour& shape : between) {
            Ring ring = surface_.add_ring(shape);
            if (at_saddle) surface_.let_free(ring, Freedom::Space, group);
            surface_.add_band(below, ring, strand_.is_hole);
            below = std::move(ring);
        }
        surface_.add_band(below, rings_[k + 1], strand_.is_hole);
    }

    //! The mean distance from a ring to the next.
    double gap_above(std::size_t k) const {
        const SampledContour& low = rings_[k].shape;
        return mean_distance(low, rings_[k + 1].shape, low.parameters);
    }
    double spacing_above(std::size_t k) const {
        return std::min(point_spacing(rings_[k].shape.points), point_spacing(rings_[k + 1].shape.points));
    }

    //! Is the way from ring to ring, in the mean, not steeper than terrain is?
    bool is_gentle_between(std::size_t k) const {
        const auto &low = rings_[k].shape.points, &high = rings_[k + 1].shape.points;
        const double gap =
            std::abs(plan_area(low) - plan_area(high)) / ((perimeter(low) + perimeter(high)) / 2);
        return kSteepest * gap >= heights_[k + 1] - heights_[k];
    }
    //! The same for a cone of this height, which is half as wide as its base's area over its perimeter tells.
    static bool is_gentle_end(const Ring& last, double rise) {
        return kSteepest * 2 * std::abs(plan_area(last.shape.points)) / perimeter(last.shape.points) >= rise;
    }

    struct SheetSide {
        const Ring* ring;
        bool is_lower;
    };

    bool add_sheet(const std::vector<SheetSide>& sides, const std::optional<Point3>& node,
                   std::uint32_t group) {
        std::vector<SheetRing> rings;
        std::vector<std::uint32_t> vertices;
        for (const auto& [ring, is_lower] : sides) {
            rings.push_back({ring->shape.points, is_lower, strand_.is_hole});
            vertices.insert(vertices.end(), ring->vertices.begin(), ring->vertices.end());
        }
        const auto& sheet = sheets_.sheet(rings, node, steps_);
        if (!sheet) return false;
        surface_.add_sheet(*sheet, std::move(vertices), group);
        return true;
    }

    void add_end(const StrandEnd& end, bool is_top) {
        const Ring& last = is_top ? rings_.back() : rings_.front();
        const bool is_ground = strand_.is_terrain && is_top != strand_.is_hole;  // not the underside
        const bool is_gentle =
            is_ground && is_gentle_end(last, std::abs(end.node.z - last.shape.points[0].z));
        if (end.kind == Kind::Tip && (join_ == Join::Sheet || (!join_ && is_gentle)) &&
            add_sheet({{&last, is_top}}, end.node, is_ground ? group_ : FreeVertices::kNoGroup))
            return;
        const bool straight = join_.has_value();
        if (straight && (end.kind == Kind::Tip || end.kind == Kind::Ridge || end.kind == Kind::Approach))
            ++straightened_;
        switch (end.kind) {
            case Kind::Flat:
                return surface_.add_flat_cap(last, is_top, strand_.is_hole);
            case Kind::Tip: {
                const std::vector<Point3> targets(last.shape.points.size(), end.node);
                return add_rows(last, straight ? kNoRows : rows_of_cap(targets, end, is_top),
                                tip_ring(end.node), is_top);
            }
            case Kind::Ridge: {
                const Ring ridge = with_origin(*end.ring, aligned_origin(last.shape, end.ring->shape));
                const std::vector<Point3> targets = points_at(ridge.shape, last.shape.parameters);
                return add_rows(last, straight ? kNoRows : rows_of_cap(targets, end, is_top), ridge, is_top);
            }
            case Kind::Approach:
                return add_rows(last, straight ? kNoRows : end.approach, *end.ring, is_top, end.group);
            case Kind::Ring:
            case Kind::Through:
            case Kind::Sheet:
                return;
        }
    }

    Ring tip_ring(const Point3& tip) {
        return {.shape = {.points = {tip}, .parameters = {0}}, .vertices = {surface_.add_point(tip)}};
    }

    //! From a contour outwards, up or down.
    void add_rows(Ring from, const std::vector<SampledContour>& rows, const Ring& end, bool upward,
                  const std::optional<std::uint32_t>& free_group = std::nullopt) {
        const auto add = [&](const Ring& to) {
            if (upward)
                surface_.add_band(from, to, strand_.is_hole);
            else
                surface_.add_band(to, from, strand_.is_hole);
        };
        for (const SampledContour& row : rows) {
            Ring ring = surface_.add_ring(row);
            if (free_group) surface_.let_free(ring, Freedom::Space, *free_group);
            add(ring);
            from = std::move(ring);
        }
        add(end);
    }

    std::vector<SampledContour> rows_of_cap(const std::vector<Point3>& targets, const StrandEnd& end,
                                            bool is_top) const {
        if (is_round_ && end.kind == Kind::Tip) return round_cap_rows(is_top);
        const CapBase base{is_top ? rings_.back().shape : rings_.front().shape,
                           is_top ? heights_.back() : heights_.front(), is_top};
        return cap_rows(base, targets, strand_, homotopy_ ? &*homotopy_ : nullptr, steps_);
    }

    //! The tip is one of the homotopy's contours.
    std::vector<SampledContour> round_cap_rows(bool is_top) const {
        const std::size_t interval = is_top ? homotopy_->intervals() - 1 : 0;
        std::vector<SampledContour> rows = homotopy_->contours_between(interval, steps_in(interval));
        if (!is_top) std::ranges::reverse(rows);
        return rows;
    }

    BandSurface& surface_;
    const Strand& strand_;
    std::size_t steps_;
    SheetMemory& sheets_;
    const std::function<std::uint32_t(std::size_t)>& begin_place_;
    std::uint32_t group_ = 0;   // of the place at hand
    std::optional<Join> join_;  // of the place at hand, if it is to be another than the homotopy's
    std::size_t straightened_ = 0;
    std::vector<Ring> rings_;  // given contours and rings at saddles that take part in the homotopy
    std::vector<double> heights_;
    std::optional<ContourHomotopy> homotopy_;
    bool is_round_ = false;  // the homotopy: see make_round_homotopy
    std::optional<MonotoneEdge> lean_;
    std::optional<SlidingHomotopy> sliding_;
};

}  // namespace

std::size_t add_strand(BandSurface& surface, const Strand& strand, std::size_t steps, SheetMemory& sheets,
                       const std::function<std::uint32_t(std::size_t place)>& begin_place) {
    return StrandBuilder(surface, strand, steps, sheets, begin_place).run();
}

}  // namespace stratareeb
