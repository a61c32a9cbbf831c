// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_contact.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <array>
#include <cmath>

namespace stratareeb {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Corners = std::array<Point, 3>;
using Indices = std::array<std::uint32_t, 3>;

// Two triangles, turned so that the `shared` corners come first and correspond to each other.
struct Pair {
    Corners a, b;
    int shared = 0;
};

Point exact(const Point3& p) {
    return {p.x, p.y, p.z};
}

Pair aligned(const TriangleSoup& soup, Indices a, Indices b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = shared; j < 3; ++j) {
            if (a[i] != b[j]) continue;
            std::swap(a[i], a[shared]);
            std::swap(b[j], b[shared]);
            ++shared;
            break;
        }
    }
    Pair pair{{}, {}, shared};
    for (int i = 0; i < 3; ++i) {
        pair.a[i] = exact(soup.points[a[i]]);
        pair.b[i] = exact(soup.points[b[i]]);
    }
    return pair;
}

// Quick proof in one projection: the line through an edge of `a` (corners i and i + 1) has the third corner
// of `a` strictly on one side and all of `b` that is not shared strictly on the other. Then they meet in
// shared corners only, and those lie on the line. Exact predicates would answer the same, but slower for
// coplanar neighbours, of which flat parts of a mesh are full.
class Shadow {
 public:
    Shadow(const Pair& pair, int drop) {
        const int u = drop == 0 ? 1 : 0, v = drop == 2 ? 1 : 2;
        for (int i = 0; i < 3; ++i) {
            a_[i] = {pair.a[i][u], pair.a[i][v]};
            b_[i] = {pair.b[i][u], pair.b[i][v]};
        }
        shared_ = pair.shared;
    }
    bool parts() const { return parted(a_, b_) || parted(b_, a_); }

 private:
    using Plan = std::array<double, 2>;
    using PlanCorners = std::array<Plan, 3>;

    // The sign of the turn p-q-r where rounding can't change it, 0 where it might. The bound is generous: the
    // exact error factor of this expression is below 4e-16.
    static int sure_side(const Plan& p, const Plan& q, const Plan& r) {
        const double left = (p[0] - r[0]) * (q[1] - r[1]);
        const double right = (p[1] - r[1]) * (q[0] - r[0]);
        const double bound = 1e-15 * (std::abs(left) + std::abs(right)) + 1e-290;
        return left - right > bound ? 1 : left - right < -bound ? -1 : 0;
    }

    bool parted(const PlanCorners& one, const PlanCorners& other) const {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            if (k < shared_) continue;  // a shared corner off the line lies on both sides
            const int side = sure_side(one[i], one[j], one[k]);
            if (side == 0) continue;
            bool clear = true;
            for (int c = shared_; c < 3 && clear; ++c) clear = sure_side(one[i], one[j], other[c]) == -side;
            if (clear) return true;
        }
        return false;
    }

    PlanCorners a_, b_;
    int shared_ = 0;
};

// The axis along which the triangle has its largest shadow.
int steepest_axis(const Corners& t) {
    const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    const double x = std::abs(normal.x()), y = std::abs(normal.y()), z = std::abs(normal.z());
    return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
}

bool parted_in_projection(const Pair& pair) {
    const int first = steepest_axis(pair.a), second = steepest_axis(pair.b);
    return Shadow(pair, first).parts() || (second != first && Shadow(pair, second).parts());
}

bool meet_across_edge(const Pair& p) {
    return CGAL::coplanar(p.a[0], p.a[1], p.a[2], p.b[2]) &&
           CGAL::coplanar_orientation(p.a[0], p.a[1], p.a[2], p.b[2]) == CGAL::POSITIVE;
}

// Do both free corners of the second triangle lie strictly on one side of the first's plane?
bool on_one_side(const Corners& plane, const Corners& other) {
    const auto side = CGAL::orientation(plane[0], plane[1], plane[2], other[1]);
    return side != CGAL::COPLANAR && side == CGAL::orientation(plane[0], plane[1], plane[2], other[2]);
}

// What they have in common is convex and holds the shared corner; if there is more, it leaves one of the
// triangles through the edge opposite that corner.
bool meet_across_vertex(const Pair& p) {
    if (on_one_side(p.a, p.b) || on_one_side(p.b, p.a)) return false;
    return CGAL::do_intersect(Triangle(p.a[0], p.a[1], p.a[2]), Segment(p.b[1], p.b[2])) ||
           CGAL::do_intersect(Triangle(p.b[0], p.b[1], p.b[2]), Segment(p.a[1], p.a[2]));
}

}  // namespace

bool TriangleContact::is_degenerate(std::uint32_t triangle) const {
    const auto& [a, b, c] = soup_.triangles[triangle];
    return CGAL::collinear(exact(soup_.points[a]), exact(soup_.points[b]), exact(soup_.points[c]));
}

bool TriangleContact::meet(std::uint32_t a, std::uint32_t b) const {
    const Pair pair = aligned(soup_, soup_.triangles[a], soup_.triangles[b]);
    if (pair.shared == 3) return true;
    if (parted_in_projection(pair)) return false;
    if (pair.shared == 2) return meet_across_edge(pair);
    if (pair.shared == 1) return meet_across_vertex(pair);
    return CGAL::do_intersect(Triangle(pair.a[0], pair.a[1], pair.a[2]),
                              Triangle(pair.b[0], pair.b[1], pair.b[2]));
}

}  // namespace stratareeb
