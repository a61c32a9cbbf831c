// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/clip_lines.h"
#include "mesh/plan_locator.h"

namespace stratareeb {

namespace {

using Rings = std::vector<std::vector<Point2>>;

struct Corner {
    Point2 at;
    std::array<double, 3> weight;
};
using Polygon = std::vector<Corner>;

struct Side {
    Point2 a, b;
};

double doubled_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Corner between(const Corner& p, const Corner& q, double share) {
    Corner result{{p.at.x + share * (q.at.x - p.at.x), p.at.y + share * (q.at.y - p.at.y)}, {}};
    for (std::size_t i = 0; i < 3; ++i) result.weight[i] = p.weight[i] + share * (q.weight[i] - p.weight[i]);
    return result;
}

//! The part of a convex polygon where `inner`, linear in place, is not negative.
template <class Inner>
Polygon clipped(const Polygon& polygon, Inner inner) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = inner(p.at), at_q = inner(q.at);
        if (at_p >= 0) result.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
            result.push_back(between(p, q, at_p / (at_p - at_q)));
    }
    return result;
}

//! What of a triangle lies below a side, between the uprights through its ends.
Polygon below(Polygon polygon, const Side& side) {
    const auto [west, east] = std::minmax(side.a.x, side.b.x);
    polygon = clipped(polygon, [west = west](const Point2& p) { return p.x - west; });
    polygon = clipped(polygon, [east = east](const Point2& p) { return east - p.x; });
    const bool eastward = side.a.x < side.b.x;
    const Point2 &from = eastward ? side.a : side.b, &to = eastward ? side.b : side.a;
    return clipped(polygon, [&](const Point2& p) { return -doubled_area(from, to, p); });
}

//! Sides of rings by the strip of x that they cross.
class SideStrips {
 public:
    explicit SideStrips(const Rings& rings) {
        low_ = high_ = rings[0][0].x;
        std::size_t count = 0;
        for (const auto& ring : rings)
            for (const Point2& p : ring) {
                low_ = std::min(low_, p.x);
                high_ = std::max(high_, p.x);
                ++count;
            }
        constexpr std::size_t kMost = 4096;
        strips_.resize(std::min(count, kMost));
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]});
    }

    //! Calls visit(side) once for each side that is over or above a box.
    template <class Visit>
    void above(double west, double east, double bottom, Visit visit) const {
        const std::size_t first = strip(west), last = strip(east);
        for (std::size_t s = first; s <= last; ++s)
            for (const std::uint32_t number : strips_[s]) {
                const Side& side = sides_[number];
                const auto [x0, x1] = std::minmax(side.a.x, side.b.x);
                if (std::max(first, strip(x0)) != s) continue;  // met before
                if (x1 > west && x0 < east && std::max(side.a.y, side.b.y) > bottom) visit(side);
            }
    }

 private:
    void add(const Side& side) {
        if (side.a.x == side.b.x) return;  // nothing lies below it
        const auto [x0, x1] = std::minmax(side.a.x, side.b.x);
        for (std::size_t s = strip(x0); s <= strip(x1); ++s)
            strips_[s].push_back(static_cast<std::uint32_t>(sides_.size()));
        sides_.push_back(side);
    }
    std::size_t strip(double x) const {
        const double last = static_cast<double>(strips_.size() - 1);
        const double share = high_ > low_ ? (x - low_) / (high_ - low_) : 0;
        return static_cast<std::size_t>(
            std::clamp(std::floor(share * static_cast<double>(strips_.size())), 0.0, last));
    }

    double low_ = 0, high_ = 0;
    std::vector<Side> sides_;
    std::vector<std::vector<std::uint32_t>> strips_;
};

class Cutter {
 public:
    Cutter(const LayerModel& model, const Rings& rings)
        : plan_(model.plan.surface), strips_(rings), is_inside_(rings), is_met_(plan_.n_faces(), 0) {
        const PlanLocator locator(plan_);
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                for (const std::uint32_t f : locator.along(ring[i], ring[(i + 1) % ring.size()]))
                    is_met_[f] = 1;
    }

    void cut(std::uint32_t face, const Polygon& triangle, double area,
             const std::function<void(const PlanPiece&)>& visit) const {
        if (is_met_[face]) return cut_met(face, triangle, visit);
        const Point2 middle{(triangle[0].at.x + triangle[1].at.x + triangle[2].at.x) / 3,
                            (triangle[0].at.y + triangle[1].at.y + triangle[2].at.y) / 3};
        if (is_inside_(middle)) visit({.face = face, .area = area});
    }

 private:
    void cut_met(std::uint32_t face, const Polygon& triangle,
                 const std::function<void(const PlanPiece&)>& visit) const {
        const auto [west, east] = std::minmax({triangle[0].at.x, triangle[1].at.x, triangle[2].at.x});
        const double bottom = std::min({triangle[0].at.y, triangle[1].at.y, triangle[2].at.y});
        strips_.above(west, east, bottom, [&](const Side& side) {
            const Polygon part = below(triangle, side);
            const double sign = side.a.x > side.b.x ? 0.5 : -0.5;  // westward sides have the area below them
            for (std::size_t i = 1; i + 1 < part.size(); ++i)
                visit({.face = face,
                       .area = sign * doubled_area(part[0].at, part[i].at, part[i + 1].at),
                       .weights = {part[0].weight, part[i].weight, part[i + 1].weight}});
        });
    }

    const TriMesh& plan_;
    SideStrips strips_;
    InsideTest is_inside_;
    std::vector<char> is_met_;
};

}  // namespace

void for_each_piece(const LayerModel& model, const std::vector<std::vector<Point2>>& areas,
                    const std::function<void(const PlanPiece&)>& visit) {
    Rings rings = areas;
    for (auto& ring : rings)
        for (Point2& p : ring) p = {p.x - model.origin.x, p.y - model.origin.y};
    std::optional<Cutter> cutter;
    if (!rings.empty()) cutter.emplace(model, rings);
    Polygon triangle(3);
    for (const auto f : model.plan.surface.faces()) {
        std::size_t i = 0;
        for (const auto v : model.plan.surface.fv_range(f)) {
            const auto& p = model.plan.surface.point(v);
            triangle[i] = {{p[0], p[1]}, {}};
            triangle[i].weight[i] = 1;
            ++i;
        }
        const double area = doubled_area(triangle[0].at, triangle[1].at, triangle[2].at) / 2;
        const auto face = static_cast<std::uint32_t>(f.idx());
        if (cutter)
            cutter->cut(face, triangle, area, visit);
        else
            visit({.face = face, .area = area});
    }
}

}  // namespace stratareeb
