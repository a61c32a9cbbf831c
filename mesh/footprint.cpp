// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/footprint.h"

#include <CGAL/box_intersection_d.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"

namespace stratareeb {

namespace {

constexpr double kSlenderest = 1e-4;  // width over length of a hull that can still be meshed

double signed_area(const std::vector<Point2>& ring) {
    double twice = 0;
    const Point2 o = ring.front();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return twice / 2;
}

struct RingEdge {
    Point2 a, b;
    std::size_t ring, index, ring_size;
};

std::vector<RingEdge> ring_edges(const Footprint& footprint) {
    std::vector<RingEdge> edges;
    for (std::size_t r = 0; r < footprint.size(); ++r)
        for (std::size_t i = 0; i < footprint[r].size(); ++i)
            edges.push_back(
                {footprint[r][i], footprint[r][(i + 1) % footprint[r].size()], r, i, footprint[r].size()});
    return edges;
}

using EdgeBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

std::vector<EdgeBox> edge_boxes(const std::vector<RingEdge>& edges) {
    std::vector<EdgeBox> boxes;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto& [a, b] = std::pair(edges[i].a, edges[i].b);
        boxes.emplace_back(
            CGAL::Bbox_2(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)), i);
    }
    return boxes;
}

void check_no_crossing(const Footprint& footprint) {
    const auto crossings = ring_crossings(footprint, {.most = 1});
    if (crossings.empty()) return;
    const Point2& place = crossings.front().place;
    throw InvalidInput(fmt::format(
        "the footprint's outline crosses or touches itself near x {:.10g}, y {:.10g}", place.x, place.y));
}

}  // namespace

Footprint hull_footprint(const HoleTriangulation& holes) {
    Footprint footprint(1);
    for (const auto& [from, to] : holes.hull_edges()) footprint[0].push_back(holes.sites()[from]);
    double length = 0;
    for (const Point2& p : footprint[0])
        length = std::max(length, std::hypot(p.x - footprint[0][0].x, p.y - footprint[0][0].y));
    if (holes.is_flat() || area(footprint) < kSlenderest * length * length)
        throw InvalidInput(
            "all holes stand in a line, so their hull has no area to speak of (give --footprint box, or a "
            "polygon file)");
    return footprint;
}

Footprint box_footprint(const std::vector<Point2>& holes, double margin) {
    const auto [x0, x1] = std::ranges::minmax(holes, {}, &Point2::x);
    const auto [y0, y1] = std::ranges::minmax(holes, {}, &Point2::y);
    const double left = x0.x - margin, right = x1.x + margin, low = y0.y - margin, high = y1.y + margin;
    if (!(right > left && high > low))
        throw InvalidInput("the box around the holes has no area (give a larger --margin)");
    return {{{left, low}, {right, low}, {right, high}, {left, high}}};
}

double suitable_margin(const HoleTriangulation& holes) {
    const auto& sites = holes.sites();
    if (!holes.is_flat())
        return std::sqrt(area(hull_footprint(holes)) / static_cast<double>(sites.size())) / 2;
    double extent = 0;
    for (const Point2& p : sites) extent = std::max(extent, std::hypot(p.x - sites[0].x, p.y - sites[0].y));
    return extent / 10;
}

bool is_inside(const Footprint& footprint, const Point2& p) {
    bool inside = false;
    for (const auto& ring : footprint)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    return inside;
}

double area(const Footprint& footprint) {
    return std::accumulate(footprint.begin(), footprint.end(), 0.0,
                           [](double sum, const auto& ring) { return sum + signed_area(ring); });
}

Footprint checked_footprint(Footprint footprint) {
    if (footprint.empty()) throw InvalidInput("the footprint has no outline");
    for (auto& ring : footprint) {
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        if (ring.size() < 3) throw InvalidInput("a ring of the footprint has fewer than three corners");
        for (const Point2& p : ring)
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                throw InvalidInput("the footprint has a corner that is not a number");
    }
    check_no_crossing(footprint);
    for (std::size_t r = 0; r < footprint.size(); ++r) {
        Footprint others = footprint;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(r));
        const bool is_hole = is_inside(others, footprint[r].front());
        const double size = signed_area(footprint[r]);
        if (size == 0) throw InvalidInput("a ring of the footprint has no area");
        if ((size > 0) == is_hole) std::ranges::reverse(footprint[r]);
    }
    return footprint;
}

Footprint with_points_on_rings(const Footprint& footprint, const std::vector<Point2>& points,
                               double tolerance) {
    const auto edges = ring_edges(footprint);
    auto boxes = edge_boxes(edges);
    std::vector<EdgeBox> point_boxes;
    for (std::size_t i = 0; i < points.size(); ++i)
        point_boxes.emplace_back(CGAL::Bbox_2(points[i].x - tolerance, points[i].y - tolerance,
                                              points[i].x + tolerance, points[i].y + tolerance),
                                 i);
    std::vector<std::vector<std::pair<double, std::size_t>>> on_edge(
        edges.size());  // place along the edge, point
    CGAL::box_intersection_d(
        boxes.begin(), boxes.end(), point_boxes.begin(), point_boxes.end(),
        [&](const EdgeBox& u, const EdgeBox& v) {
            const RingEdge& e = edges[u.info()];
            const Point2& p = points[v.info()];
            const double dx = e.b.x - e.a.x, dy = e.b.y - e.a.y, length = std::hypot(dx, dy);
            const double along = ((p.x - e.a.x) * dx + (p.y - e.a.y) * dy) / length;
            const double off = std::abs((p.x - e.a.x) * dy - (p.y - e.a.y) * dx) / length;
            if (off <= tolerance && along > 0 && along < length && !(p == e.a) && !(p == e.b))
                on_edge[u.info()].emplace_back(along, v.info());
        });
    Footprint result(footprint.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        auto& ring = result[edges[i].ring];
        ring.push_back(edges[i].a);
        std::ranges::sort(on_edge[i]);
        for (const auto& [along, point] : on_edge[i])
            if (!(ring.back() == points[point])) ring.push_back(points[point]);
    }
    return result;
}

}  // namespace stratareeb
