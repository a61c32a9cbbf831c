// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "reeb/level_set.h"
#include "reeb/reeb_graph.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

std::vector<shapes::Shape> all_shapes() {
    auto shapes = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) shapes.push_back(std::move(shape));
    return shapes;
}

//! Values 0 … n - 1 in random order, or random small integers full of ties.
ScalarField random_field(std::size_t vertices, std::mt19937_64& random, bool ties) {
    ScalarField field(vertices);
    for (std::size_t v = 0; v < vertices; ++v)
        field[v] = ties ? static_cast<double>(random() % 4) : static_cast<double>(v);
    if (!ties)
        for (std::size_t v = vertices; v > 1; --v) std::swap(field[v - 1], field[random() % v]);
    return field;
}

int count(const std::vector<CriticalPoint>& points, CriticalType type) {
    return static_cast<int>(std::ranges::count(points, type, &CriticalPoint::type));
}

TEST(CriticalPoints, indices_sum_up_to_the_euler_characteristic) {
    std::mt19937_64 random(1);
    for (const auto& shape : all_shapes()) {
        const MeshReport report = analyze(shape.soup);
        if (!report.manifold || !report.oriented) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 20; ++round) {
            const auto field = random_field(mesh.n_vertices(), random, round % 2);
            long long sum = 0;
            for (const auto& point : critical_points(mesh, field)) sum += point.index;
            EXPECT_EQ(sum, report.euler) << shape.name;
        }
    }
}

TEST(CriticalPoints, minima_less_saddles_plus_maxima_is_the_euler_characteristic_of_closed_meshes) {
    std::mt19937_64 random(2);
    for (const auto& shape : shapes::solids()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 20; ++round) {
            const auto points = critical_points(mesh, random_field(mesh.n_vertices(), random, round % 2));
            long long sum = 0;
            for (const auto& p : points) sum += p.type == CriticalType::Saddle ? -p.multiplicity : 1;
            EXPECT_EQ(sum, analyze(shape.soup).euler) << shape.name;
        }
    }
}

// Between two vertices in order nothing happens; at a vertex the number of contours changes by no more than its type allows.
TEST(CriticalPoints, say_where_the_number_of_contours_changes) {
    std::mt19937_64 random(3);
    for (const auto& shape : shapes::solids()) {
        if (shape.soup.points.size() > 300) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        const auto field = random_field(mesh.n_vertices(), random, false);
        std::vector<double> levels;
        for (std::size_t k = 0; k <= field.size(); ++k) levels.push_back(static_cast<double>(k) - 0.5);
        const auto sets = level_sets(mesh, field, levels);
        std::vector<const CriticalPoint*> at(field.size(), nullptr);
        const auto points = critical_points(mesh, field);
        for (const auto& p : points) at[static_cast<std::size_t>(p.value)] = &p;
        for (std::size_t k = 0; k < field.size(); ++k) {
            const int change =
                static_cast<int>(sets[k + 1].contours.size()) - static_cast<int>(sets[k].contours.size());
            if (!at[k]) {
                EXPECT_EQ(change, 0) << shape.name;
            } else if (at[k]->type == CriticalType::Saddle) {
                EXPECT_LE(std::abs(change), at[k]->multiplicity) << shape.name;
                EXPECT_EQ((change + at[k]->multiplicity) % 2, 0) << shape.name;
            } else {
                EXPECT_EQ(change, at[k]->type == CriticalType::Minimum ? 1 : -1) << shape.name;
            }
        }
    }
}

TEST(CriticalPoints, of_heights_on_known_shapes) {
    const auto torus = half_edge_mesh(shapes::torus(3, 1, 48, 24));
    const auto across = critical_points(torus, height_field(torus, {1, 0.1, 0.05}));
    EXPECT_EQ(count(across, CriticalType::Minimum), 1);
    EXPECT_EQ(count(across, CriticalType::Saddle), 2);
    EXPECT_EQ(count(across, CriticalType::Maximum), 1);
    const auto sphere = half_edge_mesh(shapes::uv_sphere(2, 20, 30));
    EXPECT_EQ(critical_points(sphere, height_field(sphere, {0.3, 0.2, 1})).size(), 2u);
    EXPECT_EQ(critical_points(sphere, distance_field(sphere, {0, 0, 50})).size(), 2u);
}

TEST(CriticalPoints, stand_from_bottom_to_top_and_a_monkey_saddle_counts_twice) {
    // Six spokes around a centre, alternately above and below it.
    TriangleSoup soup;
    soup.points = {{0, 0, 0}};
    for (int k = 0; k < 6; ++k)
        soup.points.push_back(
            {std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3), k % 2 ? 1.0 : -1.0});
    for (std::uint32_t k = 0; k < 6; ++k) soup.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
    const TriMesh mesh = half_edge_mesh(soup);
    const auto points = critical_points(mesh, height_field(mesh));
    const auto saddle = std::ranges::find(points, 0u, &CriticalPoint::vertex);
    ASSERT_NE(saddle, points.end());
    EXPECT_EQ(saddle->type, CriticalType::Saddle);
    EXPECT_EQ(saddle->multiplicity, 2);
    EXPECT_EQ(saddle->index, -2);
    EXPECT_FALSE(saddle->on_boundary);
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &CriticalPoint::value));
}

// Every node is a critical point; those that are none leave the number of contours as it is, also on surfaces with boundary.
TEST(CriticalPoints, that_are_no_nodes_leave_the_number_of_contours) {
    std::mt19937_64 random(4);
    int passed_on_boundary = 0;
    for (const auto& shape : all_shapes()) {
        if (shape.soup.points.size() > 300 || shape.name.find("bius") != std::string::npos) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 5; ++round) {
            const auto field = random_field(mesh.n_vertices(), random, false);
            const ReebGraph graph = reeb_graph(mesh, field);
            std::size_t nodes = 0;
            for (const auto& point : critical_points(mesh, field, graph)) {
                nodes += point.changes_level_set();
                if (point.changes_level_set()) {
                    EXPECT_EQ(graph.nodes[point.node].vertex, point.vertex);
                    EXPECT_EQ(graph.nodes[point.node].type, point.type);
                    continue;
                }
                const std::vector<double> around{point.value - 0.5, point.value + 0.5};
                const auto sets = level_sets(mesh, field, around);
                EXPECT_EQ(sets[0].contours.size(), sets[1].contours.size()) << shape.name;
                passed_on_boundary += point.on_boundary;
            }
            EXPECT_EQ(nodes, graph.nodes.size()) << shape.name;
        }
    }
    EXPECT_GT(passed_on_boundary, 10);
}

TEST(CriticalPoints, on_a_boundary_say_how_many_contours_end_there) {
    TriangleSoup soup;  // a strip whose lower rim dips twice and whose upper rim rises twice
    soup.points = {{0, 0, 1}, {1, 0, 0}, {2, 0, 1}, {3, 0, 0.1}, {4, 0, 1},
                   {0, 1, 2}, {1, 1, 3}, {2, 1, 2}, {3, 1, 3.1}, {4, 1, 2}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        soup.triangles.push_back({k, k + 1, k + 6});
        soup.triangles.push_back({k, k + 6, k + 5});
    }
    const TriMesh mesh = half_edge_mesh(soup);
    const ScalarField field = height_field(mesh);
    const auto points = critical_points(mesh, field, reeb_graph(mesh, field));
    ASSERT_EQ(points.size(),
              6u);  // two minima, one join between them, one split, two maxima, all on the rims
    const std::vector<std::uint32_t> vertices{1, 3, 2, 7, 6, 8};
    const std::vector<int> indices{1, 1, -1, 0, 0, 0};  // only what joins below changes the surface below
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_EQ(points[k].vertex, vertices[k]);
        EXPECT_EQ(points[k].index, indices[k]);
        EXPECT_TRUE(points[k].on_boundary);
        EXPECT_TRUE(points[k].changes_level_set());
    }
}

TEST(CriticalPoints, refuse_a_field_that_does_not_fit) {
    const TriMesh mesh = half_edge_mesh(shapes::cube());
    EXPECT_THROW(critical_points(mesh, ScalarField(3)), InvalidInput);
    EXPECT_THROW(critical_points(mesh, ScalarField(8, std::nan(""))), InvalidInput);
    EXPECT_TRUE(critical_points(TriMesh(), {}).empty());
}

}  // namespace
}  // namespace stratareeb
