// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertical_section.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/compensated_sum.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 exact(const Point2& p) {
    return {p.x, p.y};
}

//! Where a segment meets the plan mesh, as a share of the way along it.
struct Crossing {
    double share = 0;
    std::uint32_t from = 0, to = 0;  // the edge's vertices; equal for a vertex on the line
    double weight = 0;               // of `to`
};

//! Cuts one straight piece of the line through the plan mesh; all in the model's frame.
class SegmentCut {
 public:
    SegmentCut(const LayerModel& model, const PlanLocator& locator, const Point2& a, const Point2& b)
        : model_(model), plan_(model.plan.surface), locator_(locator), a_(a), b_(b) {
        length_ = std::hypot(b.x - a.x, b.y - a.y);
    }

    //! Stations with `along` from the segment's start, cut where the footprint ends; `runs` of one station are left out.
    std::vector<std::vector<SectionStation>> runs() {
        find_crossings();
        std::vector<SectionStation> stations;
        if (auto start = station_at(0, a_)) stations.push_back(std::move(*start));
        for (std::size_t i = 0; i < crossings_.size(); ++i) {
            const double share = std::clamp(crossings_[i].share, 0.0, 1.0);
            if (const auto fault = fault_from(i)) {
                if (stations.empty() || share * length_ > stations.back().along)
                    stations.push_back(station_on(crossings_[fault->before], share));
                else
                    stations.back() = station_on(crossings_[fault->before], stations.back().along / length_);
                const double along = stations.back().along;
                stations.push_back(station_on(crossings_[fault->behind], along / length_));
                stations.back().along = along;
                i = fault->last;
                continue;
            }
            if (!stations.empty() && share * length_ <= stations.back().along) continue;
            stations.push_back(station_on(crossings_[i], share));
        }
        if (auto end = station_at(1, b_)) {
            while (!stations.empty() && stations.back().along >= length_) stations.pop_back();
            stations.push_back(std::move(*end));
        }
        return split_outside(std::move(stations));
    }

 private:
    Point2 at(double share) const { return {a_.x + share * (b_.x - a_.x), a_.y + share * (b_.y - a_.y)}; }
    Point2 point(std::uint32_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    //! Every mesh edge that crosses the segment, once, in order along it.
    void find_crossings() {
        std::vector<std::array<std::uint32_t, 2>> edges;
        for (const std::uint32_t f : locator_.along(a_, b_))
            for (const auto h : plan_.fh_range(TriMesh::FaceHandle(static_cast<int>(f)))) {
                const auto u = static_cast<std::uint32_t>(plan_.from_vertex_handle(h).idx());
                const auto v = static_cast<std::uint32_t>(plan_.to_vertex_handle(h).idx());
                edges.push_back({std::min(u, v), std::max(u, v)});
            }
        std::ranges::sort(edges);
        const auto repeated = std::ranges::unique(edges);
        edges.erase(repeated.begin(), repeated.end());
        for (const auto& [u, v] : edges) cross(u, v);
        std::ranges::sort(crossings_, [](const Crossing& x, const Crossing& y) {
            return std::tie(x.share, x.from, x.to) < std::tie(y.share, y.from, y.to);
        });
    }

    void cross(std::uint32_t u, std::uint32_t v) {
        const Point2 p = point(u), q = point(v);
        const auto side_p = CGAL::orientation(exact(a_), exact(b_), exact(p));
        const auto side_q = CGAL::orientation(exact(a_), exact(b_), exact(q));
        if (side_p == CGAL::COLLINEAR) add_vertex(u, p);
        if (side_q == CGAL::COLLINEAR) add_vertex(v, q);
        if (side_p == CGAL::COLLINEAR || side_q == CGAL::COLLINEAR || side_p == side_q) return;
        if (CGAL::orientation(exact(p), exact(q), exact(a_)) ==
            CGAL::orientation(exact(p), exact(q), exact(b_)))
            return;
        const double to_p = std::abs(across(p)), to_q = std::abs(across(q));
        const double weight = to_p + to_q > 0 ? to_p / (to_p + to_q) : 0.5;
        crossings_.push_back(
            {share_of({p.x + weight * (q.x - p.x), p.y + weight * (q.y - p.y)}), u, v, weight});
    }

    //! Crossings at one place where the plan is cut along a fault: out of one block and into the next.
    struct FaultCrossing {
        std::size_t before, behind, last;
    };

    std::optional<FaultCrossing> fault_from(std::size_t first) const {
        constexpr double kSamePlace = 1e-10;
        std::optional<std::size_t> before, behind;
        std::size_t last = first;
        for (std::size_t i = first;
             i < crossings_.size() && crossings_[i].share - crossings_[first].share <= kSamePlace; ++i) {
            last = i;
            if (!is_boundary(crossings_[i])) continue;
            const bool comes_from = has_face_at(crossings_[i], -1), goes_to = has_face_at(crossings_[i], 1);
            if (comes_from && !goes_to && !before) before = i;
            if (goes_to && !comes_from && !behind) behind = i;
        }
        if (!before || !behind) return std::nullopt;
        return FaultCrossing{*before, *behind, last};
    }

    bool is_boundary(const Crossing& c) const {
        const TriMesh::VertexHandle u(static_cast<int>(c.from)), v(static_cast<int>(c.to));
        return c.from == c.to ? plan_.is_boundary(u)
                              : plan_.is_boundary(plan_.edge_handle(plan_.find_halfedge(u, v)));
    }

    //! A triangle at the crossing's vertex or boundary edge holds the line just before (-1) or behind (1) it.
    bool has_face_at(const Crossing& c, int direction) const {
        if (c.from != c.to) {
            TriMesh::HalfedgeHandle inner =
                plan_.find_halfedge(TriMesh::VertexHandle(static_cast<int>(c.from)),
                                    TriMesh::VertexHandle(static_cast<int>(c.to)));
            if (plan_.is_boundary(inner)) inner = plan_.opposite_halfedge_handle(inner);
            const auto edge = plan_.calc_edge_vector(inner);  // the inside to its left
            return direction * (edge[0] * (b_.y - a_.y) - edge[1] * (b_.x - a_.x)) > 0;
        }
        constexpr double kNear = 1e-8;
        const Point2 p = at(c.share + direction * kNear);
        return std::ranges::any_of(
            plan_.vf_range(TriMesh::VertexHandle(static_cast<int>(c.from))), [&](const auto f) {
                return std::ranges::all_of(plan_.fh_range(f), [&](const auto h) {
                    const Point2 u = point(static_cast<std::uint32_t>(plan_.from_vertex_handle(h).idx())),
                                 v = point(static_cast<std::uint32_t>(plan_.to_vertex_handle(h).idx()));
                    return CGAL::orientation(exact(u), exact(v), exact(p)) != CGAL::RIGHT_TURN;
                });
            });
    }

    void add_vertex(std::uint32_t v, const Point2& p) {
        const double share = share_of(p);
        if (share >= 0 && share <= 1) crossings_.push_back({share, v, v, 0});
    }

    double across(const Point2& p) const {
        return (b_.x - a_.x) * (p.y - a_.y) - (b_.y - a_.y) * (p.x - a_.x);
    }
    double share_of(const Point2& p) const {
        return ((p.x - a_.x) * (b_.x - a_.x) + (p.y - a_.y) * (b_.y - a_.y)) / (length_ * length_);
    }

    SectionStation station_on(const Crossing& c, double share) const {
        const Point2 place = c.from == c.to ? point(c.from) : at(share);
        SectionStation station{.along = share * length_, .at = place, .horizons = {}};
        for (const auto& z : model_.horizons)
            station.horizons.push_back(c.from == c.to ? z[c.from]
                                                      : (1 - c.weight) * z[c.from] + c.weight * z[c.to]);
        return station;
    }

    std::optional<SectionStation> station_at(double share, const Point2& p) const {
        const auto place = locator_.locate(p);
        if (!place) return std::nullopt;
        SectionStation station{.along = share * length_, .at = p, .horizons = {}};
        for (const auto& z : model_.horizons) station.horizons.push_back(place->value(z));
        return station;
    }

    std::vector<std::vector<SectionStation>> split_outside(std::vector<SectionStation> stations) const {
        std::vector<std::vector<SectionStation>> runs;
        for (std::size_t i = 0; i < stations.size(); ++i) {
            const bool joined =
                i > 0 && stations[i - 1].along < stations[i].along &&
                locator_.locate(at((stations[i - 1].along + stations[i].along) / (2 * length_)));
            if (!joined) runs.emplace_back();
            runs.back().push_back(std::move(stations[i]));
        }
        std::erase_if(runs, [](const auto& run) { return run.size() < 2; });
        return runs;
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    const PlanLocator& locator_;
    Point2 a_, b_;
    double length_ = 0;
    std::vector<Crossing> crossings_;
};

void move_to_map(std::vector<std::vector<SectionStation>>& runs, const Point3& origin, double along) {
    for (auto& run : runs)
        for (SectionStation& station : run) {
            station.along += along;
            station.at = {station.at.x + origin.x, station.at.y + origin.y};
            for (double& z : station.horizons) z += origin.z;
        }
}

//! A run that goes on where another ends, at a corner of the line.
bool goes_on(const std::vector<std::vector<SectionStation>>& runs, const std::vector<SectionStation>& next) {
    return !runs.empty() && runs.back().back().along == next.front().along;
}

//! The outline of one layer from its first to its last station with thickness between.
std::vector<Point2> outline_of(const std::vector<SectionStation>& run, std::size_t layer, std::size_t first,
                               std::size_t last) {
    std::vector<Point2> outline;
    const auto add = [&](double along, double z) {
        const Point2 p{along, z};
        if (outline.empty() || !(outline.back() == p)) outline.push_back(p);
    };
    for (std::size_t i = first; i <= last; ++i) add(run[i].along, run[i].horizons[layer + 1]);
    for (std::size_t i = last + 1; i-- > first;) add(run[i].along, run[i].horizons[layer]);
    while (outline.size() > 1 && outline.back() == outline.front()) outline.pop_back();
    return outline;
}

}  // namespace

VerticalSection vertical_section(const LayerModel& model, const PlanLocator& locator,
                                 const std::vector<Point2>& line) {
    VerticalSection section;
    for (const Point2& p : line) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            throw InvalidInput("the section's line has a coordinate that is no finite number");
        if (!section.line.empty() && section.line.back() == p) continue;
        const double step =
            section.line.empty() ? 0 : std::hypot(p.x - section.line.back().x, p.y - section.line.back().y);
        section.corners.push_back(section.corners.empty() ? 0 : section.corners.back() + step);
        section.line.push_back(p);
    }
    if (section.line.size() < 2)
        throw InvalidInput("a section needs a line of two points or more, not all the same");
    const auto local = [&](const Point2& p) { return Point2{p.x - model.origin.x, p.y - model.origin.y}; };
    for (std::size_t i = 0; i + 1 < section.line.size(); ++i) {
        auto runs = SegmentCut(model, locator, local(section.line[i]), local(section.line[i + 1])).runs();
        move_to_map(runs, model.origin, section.corners[i]);
        bool is_first = true;  // later ones begin beyond a gap or a fault
        for (auto& run : runs) {
            if (run.back().along > section.corners[i + 1]) run.back().along = section.corners[i + 1];
            if (std::exchange(is_first, false) && goes_on(section.runs, run))
                section.runs.back().insert(section.runs.back().end(), run.begin() + 1, run.end());
            else
                section.runs.push_back(std::move(run));
        }
        // Where the line turns inside, the next piece starts at exactly this distance.
        if (!section.runs.empty() && std::abs(section.runs.back().back().along - section.corners[i + 1]) <=
                                         1e-12 * section.corners[i + 1])
            section.runs.back().back().along = section.corners[i + 1];
    }
    if (section.runs.empty())
        throw InvalidInput(fmt::format(
            "the section's line from {:.10g}, {:.10g} to {:.10g}, {:.10g} lies outside the model's footprint",
            section.line.front().x, section.line.front().y, section.line.back().x, section.line.back().y));
    return section;
}

std::vector<SectionPolygon> section_polygons(const VerticalSection& section) {
    std::vector<SectionPolygon> polygons;
    const std::size_t layers = section.runs.empty() ? 0 : section.runs[0][0].horizons.size() - 1;
    for (std::size_t layer = 0; layer < layers; ++layer)
        for (const auto& run : section.runs) {
            const auto has = [&](std::size_t i) {
                return run[i].horizons[layer] > run[i].horizons[layer + 1];
            };
            for (std::size_t i = 0; i + 1 < run.size(); ++i) {
                if (!has(i) && !has(i + 1)) continue;
                const std::size_t first = i;
                // One body goes on while it has thickness at the station between two pieces.
                while (i + 2 < run.size() && has(i + 1)) ++i;
                polygons.push_back({layer, outline_of(run, layer, first, i + 1)});
            }
        }
    return polygons;
}

double area(const SectionPolygon& polygon) {
    CompensatedSum sum;
    const auto& p = polygon.outline;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point2 &a = p[i], &b = p[(i + 1) % p.size()];
        sum.add((a.x - p[0].x) * (b.y - p[0].y) - (b.x - p[0].x) * (a.y - p[0].y));
    }
    return sum.value() / 2;
}

double envelope_area(const VerticalSection& section) {
    CompensatedSum sum;
    for (const auto& run : section.runs)
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            const auto height = [](const SectionStation& s) {
                return s.horizons.front() - s.horizons.back();
            };
            sum.add((run[i + 1].along - run[i].along) * (height(run[i]) + height(run[i + 1])) / 2);
        }
    return sum.value();
}

}  // namespace stratareeb
