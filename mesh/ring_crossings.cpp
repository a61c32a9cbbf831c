// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ring_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <tuple>

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using EdgeBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

struct RingEdge {
    Point2 a, b;
    std::uint32_t ring = 0, place = 0;
    std::size_t corners = 0;  // of the ring

    bool is_followed_by(const RingEdge& other) const {
        return ring == other.ring && (place + 1) % corners == other.place;
    }
};

std::vector<RingEdge> edges_of(std::span<const std::vector<Point2>> rings) {
    std::vector<RingEdge> edges;
    for (std::uint32_t r = 0; r < rings.size(); ++r)
        for (std::uint32_t i = 0; i < rings[r].size(); ++i)
            edges.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()], r, i, rings[r].size()});
    return edges;
}

Kernel::Point_2 point(const Point2& p) {
    return {p.x, p.y};
}

//! Edges corner to before and corner to after, do they lie on one another?
bool folds_back(const Point2& before, const Point2& corner, const Point2& after) {
    return CGAL::orientation(point(before), point(corner), point(after)) == CGAL::COLLINEAR &&
           (before.x - corner.x) * (after.x - corner.x) + (before.y - corner.y) * (after.y - corner.y) > 0;
}

bool meet_at_corner_only(const RingEdge& e, const RingEdge& f) {
    if (e.a == f.a) return !folds_back(e.b, e.a, f.b);
    if (e.a == f.b) return !folds_back(e.b, e.a, f.a);
    if (e.b == f.a) return !folds_back(e.a, e.b, f.b);
    if (e.b == f.b) return !folds_back(e.a, e.b, f.a);
    return false;
}

bool clash(const RingEdge& e, const RingEdge& f, bool shared_corners) {
    if (!CGAL::do_intersect(Kernel::Segment_2(point(e.a), point(e.b)),
                            Kernel::Segment_2(point(f.a), point(f.b))))
        return false;
    const bool neighbours = e.is_followed_by(f) || f.is_followed_by(e);
    return !((neighbours || shared_corners) && meet_at_corner_only(e, f));
}

struct Enough {};

}  // namespace

std::vector<RingCrossing> ring_crossings(std::span<const std::vector<Point2>> rings,
                                         const RingCrossingOptions& options) {
    const std::vector<RingEdge> edges = edges_of(rings);
    std::vector<EdgeBox> boxes;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [x0, x1] = std::minmax({edges[i].a.x, edges[i].b.x});
        const auto [y0, y1] = std::minmax({edges[i].a.y, edges[i].b.y});
        boxes.emplace_back(CGAL::Bbox_2(x0, y0, x1, y1), i);
    }
    std::vector<RingCrossing> found;
    try {
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const EdgeBox& u, const EdgeBox& v) {
            const auto [i, j] = std::minmax({u.info(), v.info()});
            const RingEdge &e = edges[i], &f = edges[j];
            if (!clash(e, f, options.shared_corners)) return;
            found.push_back({e.ring, e.place, f.ring, f.place, e.a});
            if (found.size() >= options.most) throw Enough();
        });
    } catch (const Enough&) {
    }
    std::ranges::sort(found, {}, [](const RingCrossing& c) {
        return std::tuple(c.ring, c.edge, c.other_ring, c.other_edge);
    });
    return found;
}

}  // namespace stratareeb
