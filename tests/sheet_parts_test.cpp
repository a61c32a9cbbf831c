// SPDX-License-Identifier: GPL-3.0-or-later
// What sheets and fairing are made of: Laplacians, least bending, signs of links, paths to saddles, and what counts as ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mesh/analysis.h"
#include "mesh/region_triangulation.h"
#include "reeb/cotangent_weights.h"
#include "reeb/graph_of_stack.h"
#include "reeb/harmonic_heights.h"
#include "reeb/least_bending.h"
#include "reeb/link_signs.h"
#include "reeb/saddle_paths.h"
#include "reeb/terrain_stack.h"
#include "tests/shapes.h"
#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

//! Unit squares, each cut by one diagonal; n vertices along a side.
TriangleSoup grid(std::uint32_t n) {
    TriangleSoup soup;
    for (std::uint32_t r = 0; r < n; ++r)
        for (std::uint32_t c = 0; c < n; ++c) soup.points.push_back({double(c), double(r), 0});
    for (std::uint32_t r = 1; r < n; ++r)
        for (std::uint32_t c = 1; c < n; ++c) {
            const std::uint32_t v = r * n + c;
            soup.triangles.push_back({v - n - 1, v - n, v});
            soup.triangles.push_back({v - n - 1, v, v - 1});
        }
    return soup;
}

//! Vertices of a grid so far from its sides.
std::vector<bool> inner(std::uint32_t n, std::uint32_t margin) {
    std::vector<bool> result(std::size_t{n} * n, false);
    for (std::uint32_t r = margin; r + margin < n; ++r)
        for (std::uint32_t c = margin; c + margin < n; ++c) result[r * n + c] = true;
    return result;
}

void shake_plan(TriangleSoup& soup, const std::vector<bool>& which, std::mt19937& random) {
    for (std::size_t v = 0; v < which.size(); ++v)
        if (which[v]) {
            soup.points[v].x += uniform(random, -0.2, 0.2);
            soup.points[v].y += uniform(random, -0.2, 0.2);
        }
}

TEST(CotangentWeights, give_the_energy_of_linear_functions_and_the_area) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20; ++trial) {
        TriangleSoup soup = grid(8);
        shake_plan(soup, inner(8, 1), random);
        const double gx = uniform(random, -2, 2), gy = uniform(random, -2, 2);
        const auto f = [&](std::uint32_t v) { return gx * soup.points[v].x + gy * soup.points[v].y; };
        const std::vector<bool> all(soup.points.size(), true);
        for (const WeightSpace space : {WeightSpace::Plan, WeightSpace::Space}) {
            const CotangentWeights weights = cotangent_weights(soup, space, all);
            double energy = 0, area = 0;
            std::vector<double> flow(soup.points.size(), 0);
            for (const auto& [a, b, weight] : weights.edges) {
                energy += weight * (f(a) - f(b)) * (f(a) - f(b));
                flow[a] += weight * (f(b) - f(a));
                flow[b] += weight * (f(a) - f(b));
            }
            for (const double own : weights.area) area += own;
            EXPECT_NEAR(energy, (gx * gx + gy * gy) * 49, 1e-9);
            EXPECT_NEAR(area, 49, 1e-9);
            const auto inside = inner(8, 1);
            for (std::size_t v = 0; v < flow.size(); ++v)
                if (inside[v]) {
                    EXPECT_NEAR(flow[v], 0, 1e-11) << v;
                }
        }
    }
}

TEST(CotangentWeights, in_space_do_not_depend_on_where_the_surface_lies) {
    TriangleSoup soup = shapes::uv_sphere(1, 12, 20);
    const std::vector<bool> all(soup.points.size(), true);
    const CotangentWeights before = cotangent_weights(soup, WeightSpace::Space, all);
    double area = 0;
    for (const double own : before.area) area += own;
    EXPECT_NEAR(area, analyze(soup).area, 1e-12);
    for (Point3& p : soup.points) p = {p.z + 5, p.x - 3, p.y + 1};
    const CotangentWeights after = cotangent_weights(soup, WeightSpace::Space, all);
    ASSERT_EQ(after.edges.size(), before.edges.size());
    for (std::size_t i = 0; i < after.edges.size(); ++i)
        EXPECT_NEAR(after.edges[i].weight, before.edges[i].weight, 1e-9);
}

// Harmonic functions have no bending: given around, they come back between.
TEST(LeastBending, brings_planes_and_harmonic_heights_back) {
    std::mt19937 random(2);
    const std::uint32_t n = 14;
    const auto free = inner(n, 3);
    for (const bool is_plane : {true, false}) {
        TriangleSoup soup = grid(n);
        if (is_plane) shake_plan(soup, inner(n, 1), random);
        const auto height = [&](const Point3& p) {
            return is_plane ? 0.3 * p.x - 0.2 * p.y + 1
                            : 0.02 * ((p.x - 5) * (p.x - 5) - (p.y - 7) * (p.y - 7));
        };
        for (Point3& p : soup.points) p.z = height(p);
        TriangleSoup shaken = soup;
        for (std::size_t v = 0; v < free.size(); ++v)
            if (free[v]) shaken.points[v].z += uniform(random, -1, 1);
        const auto found = least_bending(shaken, free, WeightSpace::Plan);
        for (std::size_t v = 0; v < found.size(); ++v) EXPECT_NEAR(found[v].z, soup.points[v].z, 1e-8) << v;
    }
}

TEST(LeastBending, is_least_and_keeps_what_is_given) {
    std::mt19937 random(3);
    const std::uint32_t n = 12;
    const auto free = inner(n, 3), asked = inner(n, 2);
    for (int trial = 0; trial < 10; ++trial) {
        TriangleSoup soup = grid(n);
        shake_plan(soup, inner(n, 1), random);
        for (Point3& p : soup.points) p.z = uniform(random, -1, 1);
        TriangleSoup best = soup;
        best.points = least_bending(soup, free, WeightSpace::Plan);
        const double least = bending_energy(best, asked, WeightSpace::Plan);
        EXPECT_LT(least, bending_energy(soup, asked, WeightSpace::Plan));
        for (int other = 0; other < 20; ++other) {
            TriangleSoup moved = best;
            for (std::size_t v = 0; v < free.size(); ++v)
                if (free[v]) moved.points[v].z += uniform(random, -1e-2, 1e-2);
            EXPECT_GT(bending_energy(moved, asked, WeightSpace::Plan), least);
        }
        for (std::size_t v = 0; v < free.size(); ++v)
            if (!free[v]) {
                EXPECT_EQ(best.points[v], soup.points[v]);
            }
    }
}

// The indices of all vertices, 1 for lowest and highest ones and 1 - changes / 2 for others, add up to the Euler characteristic (Poincare and Hopf,
// for functions on vertices: T. Banchoff 1967), whatever the heights.
TEST(LinkSigns, add_up_to_the_euler_characteristic) {
    std::mt19937 random(4);
    for (const auto& [name, shape] : shapes::solids())
        for (int trial = 0; trial < 5; ++trial) {
            TriangleSoup soup = shape;
            for (Point3& p : soup.points)
                p.z = trial == 0 ? p.z : std::round(uniform(random, 0, trial == 1 ? 3 : 1e6));
            const auto signs = link_signs(soup, std::vector<bool>(soup.points.size(), true));
            int sum = 0;
            for (const int sign : signs) sum += sign == kLowest || sign == kHighest ? 2 : 2 - sign;
            EXPECT_EQ(sum, 2 * analyze(soup, {.self_intersections = false}).euler) << name;
        }
}

std::vector<Point2> ring(double x, double y, double radius, int corners) {
    return circle(0, x, y, radius, corners).points;
}

// Between two pits and a rim, and with three pits and two saddles: where the paths go, saddles are, and nowhere else.
TEST(SaddlePaths, leave_saddles_where_they_are_asked_for_and_nowhere_else) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 30; ++trial) {
        const bool has_three = trial % 2 == 1;
        std::vector<RegionRing> rings{{ring(-4, uniform(random, -2, 2), 1.5, 20), 0},
                                      {ring(3, uniform(random, -3, 3), 1.2, 24), 0}};
        if (has_three) rings.push_back({ring(uniform(random, -1, 1), 7, 1, 16), 0});
        rings.push_back({ring(0, 1, 10, 60), 1});
        std::vector<Point2> saddles{{uniform(random, -1.5, 0.5), uniform(random, -1, 1)}};
        if (has_three) saddles.push_back({uniform(random, 0.5, 2), 4.6});
        std::vector<RegionPoint> inside;
        for (const Point2& p : saddles) {
            inside.push_back({p, 0.3});
            for (int i = 0; i < 12; ++i) {
                const double angle = std::numbers::pi / 6 * i;
                inside.push_back({{p.x + 0.5 * std::cos(angle), p.y + 0.5 * std::sin(angle)}, 0.3});
            }
        }
        const auto region = triangulate_region(rings, inside, {.largest_edge = 0.7});
        TriangleSoup plan;
        std::vector<std::uint32_t> ring_of;
        for (std::uint32_t r = 0; r < rings.size(); ++r)
            for (const Point2& p : rings[r].points) {
                plan.points.push_back({p.x, p.y, 0});
                ring_of.push_back(r);
            }
        const std::size_t given = plan.points.size();
        for (const RegionPoint& p : inside) plan.points.push_back({p.place.x, p.place.y, 0});
        for (const Point2& p : region.added) plan.points.push_back({p.x, p.y, 0});
        plan.triangles = region.triangles;
        ring_of.resize(plan.points.size(), PathRegion::kInside);
        std::vector<SheetSaddle> asked{{static_cast<std::uint32_t>(given), {0, 1}}};
        if (has_three) asked.push_back({static_cast<std::uint32_t>(given + 13), {1, 2}});
        std::vector<double> heights(rings.size(), 1.0);
        heights.back() = 3;
        const auto fixed = saddle_path_heights({plan, ring_of}, asked, {heights, 2});
        ASSERT_TRUE(fixed) << trial;
        const auto all = harmonic_heights(plan, *fixed);
        ASSERT_TRUE(all) << trial;
        std::vector<bool> is_inside(plan.points.size(), false);
        for (std::size_t v = 0; v < plan.points.size(); ++v) {
            plan.points[v].z = (*all)[v];
            is_inside[v] = v >= given;
        }
        const auto signs = link_signs(plan, is_inside);
        for (std::uint32_t v = 0; v < signs.size(); ++v) {
            if (!is_inside[v]) continue;
            const bool is_saddle = std::ranges::any_of(asked, [&](const auto& s) { return s.vertex == v; });
            EXPECT_EQ(signs[v], is_saddle ? 4 : 2) << trial << ", vertex " << v;
        }
    }
}

EnhancedReebGraph graph(std::vector<StackContour> contours) {
    return graph_of_stack({std::move(contours)}).graph;
}

TEST(IsTerrain, knows_ground_from_overhangs) {
    EXPECT_TRUE(is_terrain(graph({circle(0, 0, 0, 9), circle(1, 0, 0, 6), circle(2, 1, 0, 3)})));
    EXPECT_TRUE(is_terrain(graph({circle(0, 0, 0, 9), circle(1, 0, 0, 8), circle(1, 0, 0, 3),
                                  circle(2, 0, 0, 7), circle(2, 0, 0, 4)})))
        << "a crater";
    EXPECT_FALSE(is_terrain(graph({circle(0, 0, 0, 5), circle(1, 0, 0, 6), circle(2, 0, 0, 3)})))
        << "wider above";
    EXPECT_FALSE(is_terrain(graph({circle(0, 0, 0, 9), circle(1, 4, 0, 8), circle(2, 8, 0, 7)})))
        << "leaning";
    EXPECT_FALSE(
        is_terrain(graph({circle(0, 0, 0, 9), circle(1, 0, 0, 8), circle(1, 0, 0, 3), circle(2, 0, 0, 7)})))
        << "a cave";
}

}  // namespace
}  // namespace stratareeb
