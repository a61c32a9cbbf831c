// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/joint_parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/analysis.h"
#include "reeb/point_math.h"
#include "reeb/surface_construction.h"

namespace stratareeb {
namespace {

SampledContour star(std::mt19937_64& random, std::size_t corners) {
    std::uniform_real_distribution<double> radius(0.5, 2);
    std::vector<Point3> points;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners),
                     r = radius(random);
        points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    return contour_by_perimeter(std::move(points));
}

//! From the segment between a and b.
double off(const Point3& p, const Point3& a, const Point3& b) {
    const Point3 side = b - a;
    const double square = dot_product(side, side),
                 share = square > 0 ? std::clamp(dot_product(p - a, side) / square, 0.0, 1.0) : 0;
    return magnitude(p - a - share * side);
}

TEST(JointParameters, keep_all_of_the_first_and_every_corner_of_the_second) {
    std::mt19937_64 random(11);
    std::uniform_int_distribution<std::size_t> corners(3, 60);
    for (int round = 0; round < 300; ++round) {
        const SampledContour own = with_origin(star(random, corners(random)), 0.3),
                             other = star(random, corners(random));
        const auto joint = joint_parameters(own, other);
        ASSERT_TRUE(std::ranges::is_sorted(joint));
        ASSERT_EQ(std::ranges::adjacent_find(joint), joint.end());
        ASSERT_TRUE(std::ranges::includes(joint, own.parameters));
        ASSERT_LE(joint.size(), own.points.size() + other.points.size());
        ASSERT_LT(joint.back(), 1);
        const auto kept = points_at(other, joint);
        for (std::size_t i = 0; i < other.points.size(); ++i) {
            const auto above = static_cast<std::size_t>(std::ranges::upper_bound(joint, other.parameters[i]) -
                                                        joint.begin());
            const Point3 &a = kept[(above + joint.size() - 1) % joint.size()],
                         &b = kept[above % joint.size()];
            EXPECT_LE(off(other.points[i], a, b), 0.005 * magnitude(b - a) + 1e-12);
        }
    }
}

TEST(JointParameters, leave_out_what_the_second_needs_no_point_for) {
    const auto square = contour_by_perimeter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    EXPECT_EQ(joint_parameters(square, with_short_sides(square, 0.01)), square.parameters);
    EXPECT_EQ(joint_parameters(square, square), square.parameters);
    const SampledContour tip{.points = {{0, 0, 1}}, .parameters = {0}};
    EXPECT_EQ(joint_parameters(square, tip), square.parameters);
    const auto beside = with_origin(square, 1e-9);  // corners all but at the same places
    EXPECT_EQ(joint_parameters(square, beside), square.parameters);
}

TEST(JointParameters, of_a_long_spiral_take_no_time) {
    std::vector<Point3> points;
    for (int i = 0; i < 200'000; ++i) {
        const double angle = 0.001 * i;
        points.push_back({(1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle), 0});
    }
    const auto square = contour_by_perimeter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    EXPECT_GT(joint_parameters(square, contour_by_perimeter(std::move(points))).size(), 1000u);
}

//! The area of the polygon through both contours' points at all their parameters, mixed by t.
double mixed_area(const SampledContour& a, const SampledContour& b, double t) {
    std::vector<double> s = a.parameters;
    s.insert(s.end(), b.parameters.begin(), b.parameters.end());
    std::ranges::sort(s);
    const auto p = points_at(a, s), q = points_at(b, s);
    double twice = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const std::size_t k = (i + 1) % s.size();
        const Point3 u = p[i] + t * (q[i] - p[i]), v = p[k] + t * (q[k] - p[k]);
        twice += u.x * v.y - v.x * u.y;
    }
    return twice / 2;
}

// Between contours whose corners lie elsewhere. The area is quadratic in t: Simpson's rule is exact.
TEST(JointParameters, cut_no_corner_off_a_square_that_becomes_a_triangle) {
    const std::vector<Point3> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
        triangle{{-1, -0.6, 1}, {1, -0.6, 1}, {0, 1.2, 1}};
    EnhancedReebGraph graph;
    for (const double z : {0.0, 1.0}) {
        graph.nodes.emplace_back().position = {0, 0, z};
        graph.nodes.back().id = static_cast<std::int64_t>(z);
        graph.contours.emplace_back().id = static_cast<std::int64_t>(z);
        graph.contours.back().curve.closed = true;
        graph.contours.back().curve.points = z == 0 ? square : triangle;
    }
    graph.edges.push_back({.from = 0, .to = 1, .curve = {}, .contours = {0, 1}, .homotopy = {}});
    graph.edges[0].homotopy.kind = HomotopyKind::Linear;
    const auto surface = construct_surface(graph, {.steps = 200});
    const MeshReport report = analyze(surface.soup);
    EXPECT_TRUE(report.watertight);
    const auto a = contour_by_perimeter(square);
    // The second is turned to the first (correspondence): of the triangle's origins the one that its surface has.
    double best = 1e9;
    for (int k = 0; k < 3000; ++k) {
        const auto b = with_origin(contour_by_perimeter(triangle), k / 3000.0);
        const double volume = (mixed_area(a, b, 0) + 4 * mixed_area(a, b, 0.5) + mixed_area(a, b, 1)) / 6;
        best = std::min(best, std::abs(report.volume - volume));
    }
    EXPECT_LT(best, 2e-3);
    // No step: neighbouring slices of 1/200 differ by a 100th at most.
    std::vector<std::vector<Point3>> rows(201);
    for (const Point3& p : surface.soup.points)
        rows[static_cast<std::size_t>(std::lround(p.z * 200))].push_back(p);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto reach = [](const std::vector<Point3>& row) {
            return std::ranges::max(row, {}, &Point3::x).x;
        };
        EXPECT_LT(std::abs(reach(rows[i]) - reach(rows[i - 1])), 0.01) << i;
    }
}

}  // namespace
}  // namespace stratareeb
