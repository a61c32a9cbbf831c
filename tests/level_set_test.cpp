// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/level_set.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using std::numbers::pi;

double total_length(const LevelSet& set) {
    double sum = 0;
    for (const auto& contour : set.contours) sum += contour.length();
    return sum;
}

double total_area(const LevelSet& set) {
    double sum = 0;
    for (const auto& contour : set.contours) sum += contour.plan_area();
    return sum;
}

TEST(LevelSet, circles_of_a_sphere_converge_to_second_order) {
    double before = 0;
    for (const std::uint32_t n : {16u, 32u, 64u, 128u}) {
        const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(2, n, 2 * n));
        const auto set = level_sets(sphere, height_field(sphere), std::array{0.7})[0];
        ASSERT_EQ(set.contours.size(), 1u);
        EXPECT_TRUE(set.contours[0].closed);
        const double r = std::sqrt(4 - 0.49);
        const double error =
            std::abs(total_length(set) - 2 * pi * r) + std::abs(total_area(set) - pi * r * r);
        EXPECT_GT(total_area(set), 0) << "higher ground on the left: counter-clockwise around a summit";
        if (before > 0) {
            EXPECT_LT(error, before / 2.5);
        }
        before = error;
    }
    EXPECT_LT(before, 0.02);
}

TEST(LevelSet, total_length_over_many_levels_of_a_sphere) {
    const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(1, 120, 240));
    const auto field = height_field(sphere);
    const auto sets = level_sets(sphere, field, even_levels(field, 999));
    double sum = 0;
    for (const auto& set : sets) sum += total_length(set);
    EXPECT_NEAR(sum * 2 / 1000, pi * pi, 2e-3 * pi * pi);  // the integral of 2 pi sqrt(1 - z^2) over z
}

TEST(LevelSet, a_lying_torus_has_two_circles_at_each_level) {
    const TriMesh torus = half_edge_mesh(shapes::torus(3, 1, 400, 200));
    const auto set = level_sets(torus, height_field(torus), std::array{0.4})[0];
    ASSERT_EQ(set.contours.size(), 2u);
    const double half = std::sqrt(1 - 0.16);
    EXPECT_NEAR(total_length(set), 2 * pi * 6, 1e-2);
    EXPECT_NEAR(total_area(set), pi * ((3 + half) * (3 + half) - (3 - half) * (3 - half)), 2e-2);
    EXPECT_LT(set.contours[0].plan_area() * set.contours[1].plan_area(), 0)
        << "the inner one runs the other way";
}

TEST(LevelSet, areas_integrate_to_the_volume) {
    std::mt19937_64 random(5);
    for (const auto& shape : shapes::solids()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        const auto field = height_field(mesh);
        const auto [low, high] = std::ranges::minmax(field);
        if (!(high > low)) continue;
        constexpr std::size_t kLevels = 2000;
        std::vector<double> levels;  // midpoint rule
        for (std::size_t k = 0; k < kLevels; ++k)
            levels.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / kLevels);
        double sum = 0;
        for (const auto& set : level_sets(mesh, field, levels)) sum += total_area(set);
        EXPECT_NEAR(sum * (high - low) / kLevels, volume(mesh), 2e-3 * volume(mesh)) << shape.name;
    }
}

TEST(LevelSet, takes_every_crossed_edge_once_without_gaps) {
    std::mt19937_64 random(6);
    auto shapes = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) shapes.push_back(std::move(shape));
    for (const auto& shape : shapes) {
        const MeshReport report = analyze(shape.soup);
        if (!report.manifold || !report.oriented) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 5; ++round) {
            ScalarField field(mesh.n_vertices());
            for (double& value : field) value = static_cast<double>(random() % 1000000) + 0.5;
            const double level = static_cast<double>(random() % 1000000);
            std::size_t crossed = 0, boundary = 0;
            for (const auto e : mesh.edges()) {
                const auto h = mesh.halfedge_handle(e, 0);
                const bool a = field[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())] >= level;
                const bool b = field[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())] >= level;
                crossed += a != b;
                boundary += a != b && mesh.is_boundary(e);
            }
            std::size_t points = 0, open = 0;
            const auto sets = level_sets(mesh, field, std::array{level});
            for (const auto& contour : sets[0].contours) {
                points += contour.points.size();
                open += !contour.closed;
                for (std::size_t i = 0; i + 1 < contour.points.size(); ++i)
                    EXPECT_FALSE(contour.points[i] == contour.points[i + 1]);
            }
            EXPECT_EQ(points, crossed) << shape.name;
            EXPECT_EQ(2 * open, boundary) << shape.name;
        }
    }
}

TEST(LevelSet, is_exact_at_the_height_of_vertices_and_plateaus) {
    // A pyramid with a flat top: the level of the plateau runs along its rim.
    const TriMesh box = half_edge_mesh(shapes::slab(2, 3, 1));
    const auto top = level_sets(box, height_field(box), std::array{1.0, 0.5, 0.0, 1.5})[0];
    ASSERT_EQ(top.contours.size(), 1u);
    EXPECT_EQ(top.contours[0].points.size(), 4u);
    EXPECT_DOUBLE_EQ(top.contours[0].length(), 10);
    EXPECT_DOUBLE_EQ(top.contours[0].plan_area(), 6);
    const auto all = level_sets(box, height_field(box), std::array{0.5, 0.0, 1.5});
    EXPECT_DOUBLE_EQ(total_area(all[0]), 6);
    EXPECT_TRUE(all[1].contours.empty()) << "everything is above or at its lowest level";
    EXPECT_TRUE(all[2].contours.empty());
    const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(1, 10, 20));  // a ring of vertices at the equator
    const auto equator = level_sets(sphere, height_field(sphere),
                                    std::array{sphere.point(TriMesh::VertexHandle(1 + 4 * 20))[2]})[0];
    ASSERT_EQ(equator.contours.size(), 1u);
    EXPECT_EQ(equator.contours[0].points.size(), 20u);
}

TEST(LevelSet, returns_levels_in_the_order_asked_for_and_refuses_what_is_no_number) {
    const TriMesh cube = half_edge_mesh(shapes::cube());
    const auto field = height_field(cube);
    const auto sets = level_sets(cube, field, std::array{0.9, 0.1, 0.9});
    ASSERT_EQ(sets.size(), 3u);
    EXPECT_EQ(sets[0].level, 0.9);
    EXPECT_EQ(sets[1].level, 0.1);
    EXPECT_EQ(sets[2].contours.size(), 1u);
    EXPECT_THROW(level_sets(cube, field, std::array{std::nan("")}), InvalidInput);
    EXPECT_THROW(level_sets(cube, ScalarField(2), std::array{0.5}), InvalidInput);
    EXPECT_TRUE(level_sets(TriMesh(), {}, std::array{0.5})[0].contours.empty());
    EXPECT_EQ(even_levels({0, 10}, 4), (std::vector<double>{2, 4, 6, 8}));
    EXPECT_THROW(height_field(cube, {0, 0, 0}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
