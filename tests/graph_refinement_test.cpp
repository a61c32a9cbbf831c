// SPDX-License-Identifier: GPL-3.0-or-later
// How near a surface comes to the mesh that its graph is of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mesh/self_intersection.h"
#include "mesh/surface_distance.h"
#include "reeb/graded_levels.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/surface_crossings.h"
#include "reeb/surface_of_graph.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

//! A little sheared, so that no two critical points have one height.
TriangleSoup tilted(TriangleSoup soup) {
    for (Point3& p : soup.points)
        p = {p.x + 0.0077 * p.z, p.y - 0.0123 * p.z, p.z - 0.0077 * p.x + 0.0123 * p.y};
    return soup;
}

TriangleSoup upright_torus(std::size_t finer = 1) {
    TriangleSoup torus = shapes::torus(3, 1, 120 * finer, 60 * finer);
    for (Point3& p : torus.points) p = {p.y, p.z, p.x};
    return tilted(torus);
}

TriangleSoup ellipsoid(std::size_t finer = 1) {
    TriangleSoup soup = shapes::uv_sphere(1, 90 * finer, 120 * finer);
    for (Point3& p : soup.points) p = {3 * p.x + 0.8 * p.z, 2 * p.y, 1.5 * p.z};
    return tilted(soup);
}

double farthest(const TriangleSoup& from, const TriangleSoup& to) {
    return std::ranges::max(SurfaceDistance(to).of(surface_samples(from, 0.05)));
}

double hausdorff(const TriangleSoup& a, const TriangleSoup& b) {
    return std::max(farthest(a, b), farthest(b, a));
}

TEST(GraphRefinement, tolerance_bounds_the_surface_with_caps_and_saddles) {
    for (const auto& [name, soup] : std::vector<std::pair<std::string, TriangleSoup>>{
             {"ellipsoid", ellipsoid()}, {"torus", upright_torus()}}) {
        const TriMesh mesh = half_edge_mesh(soup);
        std::size_t contours = 0;
        for (const double tolerance : {0.2, 0.1}) {
            const auto graph = graph_of_mesh(mesh, {.levels = 2, .tolerance = tolerance});
            EXPECT_LE(hausdorff(soup, surface_of_graph(graph).soup), tolerance) << name;
            EXPECT_GE(graph.contours.size(), contours);
            contours = graph.contours.size();
        }
    }
}

//! Turned so that no edge or side is level or upright.
TriangleSoup askew(TriangleSoup soup) {
    for (Point3& p : soup.points) p = {p.x + 0.31 * p.z, p.y - 0.23 * p.z, p.z - 0.41 * p.x + 0.37 * p.y};
    return soup;
}

TEST(GraphRefinement, tolerance_bounds_surfaces_with_edges_and_holes) {
    const TriangleSoup terrain =
        shapes::terrain_solid(8, 3, [](double x, double y) { return std::sin(0.9 * x) * std::cos(1.1 * y); });
    for (const auto& [name, soup] : std::vector<std::pair<std::string, TriangleSoup>>{
             {"cube", askew(shapes::cube())},
             {"tetrahedron", askew(shapes::tetrahedron())},
             {"prism", askew(shapes::prism(7, 1, 3))},
             {"plate with two holes", askew(shapes::double_torus())},
             {"terrain", tilted(terrain)}}) {
        const auto [low, high] = std::ranges::minmax(soup.points, {}, &Point3::z);
        const double tolerance = 0.04 * (high.z - low.z);
        const auto graph = graph_of_mesh(half_edge_mesh(soup), {.levels = 3, .tolerance = tolerance});
        const TriangleSoup rebuilt = surface_of_graph(graph).soup;
        EXPECT_LE(hausdorff(soup, rebuilt), tolerance) << name;
        EXPECT_EQ(self_intersections(rebuilt).count, 0u) << name;
    }
}

// Meshes fine enough that their own chords don't show: a distance of second order falls with the square of the levels.
TEST(GraphRefinement, smooth_shapes_come_nearer_with_the_square_of_the_levels) {
    const auto order = [](const TriangleSoup& soup, std::size_t few, std::size_t many) {
        const TriMesh mesh = half_edge_mesh(soup);
        const auto error = [&](std::size_t levels) {
            const TriangleSoup rebuilt = surface_of_graph(graph_of_mesh(mesh, {.levels = levels})).soup;
            return std::max(std::ranges::max(SurfaceDistance(soup).of(rebuilt.points)),
                            std::ranges::max(SurfaceDistance(rebuilt).of(soup.points)));
        };
        return std::log(error(few) / error(many)) /
               std::log(static_cast<double>(many) / static_cast<double>(few));
    };
    EXPECT_GT(order(ellipsoid(4), 3, 12), 1.8);
    EXPECT_GT(order(upright_torus(2), 4, 32), 1.8);
}

TEST(GradedLevels, are_squares_of_even_steps_beside_graded_ends) {
    const std::vector<double> levels{10, 11, 12, 13, 14, 15, 16, 17, 18};  // 3 steps, spacing 1
    const auto none = graded_levels(levels, 9.5, 14.5, {});
    EXPECT_EQ(none, (std::vector<double>{10, 11, 12, 13, 14}));
    const auto low = graded_levels(levels, 11.1, 15.9, {.low = true});
    ASSERT_EQ(low.size(), 6u);
    EXPECT_NEAR(low[0], 11.1 + 1 / 9.0, 1e-12);
    EXPECT_NEAR(low[1], 11.1 + 4 / 9.0, 1e-12);
    EXPECT_EQ(low[2], 12);
    const auto both = graded_levels(levels, 11.1, 15.9, {.low = true, .high = true});
    EXPECT_EQ(both.size(), 8u);
    EXPECT_TRUE(std::ranges::is_sorted(both));
    EXPECT_TRUE(graded_levels(levels, 11.2, 11.8, {.low = true, .high = true}).empty());
    EXPECT_TRUE(graded_levels({}, 0, 1, {.low = true}).empty());
}

TEST(GraphRefinement, no_place_takes_the_room_of_others) {
    const TriMesh mesh = half_edge_mesh(ellipsoid());
    const auto graph = graph_of_mesh(mesh, {.levels = 2, .tolerance = 1e-6, .most_per_arc = 12});
    ASSERT_EQ(graph.edges.size(), 1u);
    EXPECT_EQ(graph.contours.size(), 12u);
    std::vector<double> heights;
    for (const EnhancedNode& node : graph.nodes) heights.push_back(node.position.z);
    for (const EnhancedContour& contour : graph.contours) heights.push_back(contour.curve.points.front().z);
    std::ranges::sort(heights);
    for (std::size_t i = 1; i < heights.size(); ++i)
        EXPECT_LT(heights[i] - heights[i - 1], 0.3 * (heights.back() - heights.front()));
}

//! Some triangles leave, some come, the others get other numbers and begin with another corner.
TriangleSoup changed(const TriangleSoup& before, std::mt19937& random) {
    TriangleSoup soup = before;
    std::uniform_real_distribution<double> shake(-0.2, 0.2);
    for (Point3& p : soup.points)
        if (random() % 8 == 0) p = {p.x + shake(random), p.y + shake(random), p.z + shake(random)};
    std::ranges::shuffle(soup.triangles, random);
    soup.triangles.resize(soup.triangles.size() - random() % 4);
    for (auto& t : soup.triangles) std::ranges::rotate(t, t.begin() + static_cast<int>(random() % 3));
    return soup;
}

TEST(CrossingSearch, finds_in_each_surface_what_a_search_of_its_own_does) {
    std::mt19937 random(7);
    std::size_t crossing = 0;
    for (const std::size_t named : {100'000u, 5u}) {
        CrossingSearch search;
        TriangleSoup soup = shapes::joined(shapes::uv_sphere(1, 12, 16),
                                           shapes::moved(shapes::uv_sphere(1, 12, 16), 2.1, 0.2, 0.1));
        for (int round = 0; round < 40; ++round) {
            const auto expected = self_intersections(soup, named), found = search.of(soup, named);
            EXPECT_EQ(found.count, expected.count) << round;
            EXPECT_EQ(found.first, expected.first) << round;
            crossing += expected.count > 0;
            soup = changed(soup, random);
        }
    }
    EXPECT_GT(crossing, 40u);
}

}  // namespace
}  // namespace stratareeb
