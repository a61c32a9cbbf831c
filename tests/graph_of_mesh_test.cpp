// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_of_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/analysis.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/graph_conditions.h"
#include "reeb/surface_of_graph.h"
#include "tests/arc_heights.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using testing::arcs_of;

//! Turned about x and y, so that no two vertices of a regular shape have one height.
TriangleSoup tilted(TriangleSoup soup, double about_x = 0.0123, double about_y = 0.0077) {
    for (Point3& p : soup.points) {
        const double y = p.y * std::cos(about_x) - p.z * std::sin(about_x),
                     z = p.y * std::sin(about_x) + p.z * std::cos(about_x);
        p = {p.x * std::cos(about_y) + z * std::sin(about_y), y,
             z * std::cos(about_y) - p.x * std::sin(about_y)};
    }
    return soup;
}

//! There and back: mesh to graph to mesh has the same Reeb graph, and how much its volume is off.
double volume_error_of_round_trip(const TriangleSoup& soup, MeshGraphOptions options,
                                  const std::string& name) {
    options.crossing_rounds = 0;
    const TriMesh mesh = half_edge_mesh(soup);
    const ReebGraph before = collapse_plateaus(reeb_graph(mesh, height_field(mesh)));
    const EnhancedReebGraph graph = graph_of_mesh(mesh, options);
    EXPECT_TRUE(faults_of(graph).empty())
        << name << ": " << (faults_of(graph).empty() ? "" : faults_of(graph)[0]);
    const auto surface = surface_of_graph(graph, {.steps = 3, .avoid_crossings = false});
    const MeshReport report = analyze(surface.soup, {.self_intersections = false}),
                     original = analyze(soup, {.self_intersections = false});
    EXPECT_TRUE(report.closed && report.manifold && report.oriented) << name;
    EXPECT_EQ(report.genus, original.genus) << name;
    EXPECT_EQ(report.components, original.components) << name;
    const TriMesh rebuilt = half_edge_mesh(surface.soup);
    const ReebGraph after = collapse_plateaus(reeb_graph(rebuilt, height_field(rebuilt)));
    EXPECT_EQ(arcs_of(after), arcs_of(before)) << name;
    return std::abs(std::abs(report.volume) / std::abs(original.volume) - 1);
}

TEST(GraphOfMesh, leads_back_to_a_mesh_with_the_same_graph) {
    const std::vector<std::pair<std::string, TriangleSoup>> shapes{
        {"sphere", shapes::uv_sphere(2, 24, 36)},
        {"torus", shapes::torus(3, 1, 48, 24)},
        {"double torus", shapes::double_torus()},
        {"plate of genus 4", shapes::plate_with_holes(2)},
        {"plate of genus 9", shapes::plate_with_holes(3)},
        {"two spheres", shapes::joined(shapes::uv_sphere(1, 16, 16),
                                       shapes::moved(shapes::uv_sphere(1, 12, 14), 4, 0, 0.3))},
        {"terrain solid",
         shapes::terrain_solid(10, 2, [](double x, double y) { return std::sin(x) * std::cos(0.7 * y); })},
    };
    for (const auto& [name, soup] : shapes)
        for (const auto& [ax, ay] :
             std::vector<std::pair<double, double>>{{0.0123, 0.0077}, {1.3, 0.4}, {0.5, -1.1}}) {
            const double error = volume_error_of_round_trip(tilted(soup, ax, ay), {.levels = 20}, name);
            EXPECT_LT(error, 0.05) << name;
        }
}

TEST(GraphOfMesh, comes_closer_with_more_levels) {
    const TriangleSoup torus = tilted(shapes::torus(3, 1, 180, 90));
    double before = 1;
    for (const std::size_t levels : {5u, 10u, 20u, 40u}) {
        const double error = volume_error_of_round_trip(torus, {.levels = levels}, "torus");
        EXPECT_LT(error, before) << levels;
        before = error;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(GraphOfMesh, takes_contours_where_the_tolerance_asks_for_them) {
    const TriMesh mesh = half_edge_mesh(tilted(shapes::uv_sphere(1, 64, 64)));
    std::size_t before = graph_of_mesh(mesh, {.levels = 2}).contours.size();
    for (const double tolerance : {0.1, 0.02, 0.005}) {
        const std::size_t count = graph_of_mesh(mesh, {.levels = 2, .tolerance = tolerance}).contours.size();
        EXPECT_GE(count, before) << tolerance;
        before = count;
    }
    EXPECT_GT(before, 4u);
    EXPECT_LT(before, 60u);
}

constexpr double kExact = 1e-5;  // contours are turned to one another no more exactly

//! Level faces, whole or with holes, above and below, and shelves on which nothing merges or splits, come back as they were.
TEST(GraphOfMesh, keeps_level_faces) {
    const std::vector<std::pair<std::string, TriangleSoup>> shapes{
        {"cube", shapes::cube()},
        {"prism", shapes::prism(7, 2, 3)},
        {"plate of genus 1", shapes::plate_with_holes(1)},
        {"plate of genus 9", shapes::plate_with_holes(3)},
        {"wheel of a lying torus", shapes::torus(3, 1, 48, 24)},
        {"two cubes", shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 3, 0, 0))},
        {"cubes at two heights", shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 3, 0, 1))},
    };
    for (const auto& [name, soup] : shapes) {
        const double error = volume_error_of_round_trip(soup, {.levels = 5}, name);
        EXPECT_LT(error, name.find("torus") == std::string::npos ? kExact : 0.05) << name;
    }
}

//! A block of unit cubes on a grid, their surface: steps, holes, overhangs and terraces at whole heights.
TriangleSoup cubes(int nx, int ny, int nz, const std::function<bool(int, int, int)>& is_solid) {
    const auto solid = [&](int x, int y, int z) {
        return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && is_solid(x, y, z);
    };
    TriangleSoup soup;
    std::map<std::array<int, 3>, std::uint32_t> number;
    const auto corner = [&](int x, int y, int z) {
        const auto [at, is_new] =
            number.try_emplace({x, y, z}, static_cast<std::uint32_t>(soup.points.size()));
        if (is_new) soup.points.push_back({double(x), double(y), double(z)});
        return at->second;
    };
    const auto face = [&](std::array<int, 3> o, std::array<int, 3> u, std::array<int, 3> v) {
        const auto at = [&](int i, int k) {
            return corner(o[0] + i * u[0] + k * v[0], o[1] + i * u[1] + k * v[1], o[2] + i * u[2] + k * v[2]);
        };
        const auto a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
    };
    for (int x = 0; x < nx; ++x)
        for (int y = 0; y < ny; ++y)
            for (int z = 0; z < nz; ++z) {
                if (!solid(x, y, z)) continue;
                if (!solid(x + 1, y, z)) face({x + 1, y, z}, {0, 1, 0}, {0, 0, 1});
                if (!solid(x - 1, y, z)) face({x, y, z}, {0, 0, 1}, {0, 1, 0});
                if (!solid(x, y + 1, z)) face({x, y + 1, z}, {0, 0, 1}, {1, 0, 0});
                if (!solid(x, y - 1, z)) face({x, y, z}, {1, 0, 0}, {0, 0, 1});
                if (!solid(x, y, z + 1)) face({x, y, z + 1}, {1, 0, 0}, {0, 1, 0});
                if (!solid(x, y, z - 1)) face({x, y, z}, {0, 1, 0}, {1, 0, 0});
            }
    return soup;
}

TEST(GraphOfMesh, rebuilds_steps_arches_and_terraces_exactly) {
    const std::vector<std::pair<std::string, TriangleSoup>> shapes{
        {"stairs", cubes(3, 2, 3, [](int x, int, int z) { return z <= x; })},
        {"pyramid", cubes(5, 5, 3,
                          [](int x, int y, int z) {
                              return std::min({x, y, 4 - x, 4 - y}) >= z;
                          })},
        {"table", cubes(4, 4, 2, [](int x, int y, int z) { return z == 1 || (x % 3 == 0 && y % 3 == 0); })},
        {"arch", cubes(3, 1, 2, [](int x, int, int z) { return z == 1 || x != 1; })},
        {"box with a cavity", cubes(3, 3, 3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; })},
        {"Menger sponge",
         cubes(3, 3, 3, [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; })},
    };
    for (const auto& [name, soup] : shapes) {
        ASSERT_TRUE(analyze(soup).manifold) << name;
        EXPECT_LT(volume_error_of_round_trip(soup, {.levels = 4}, name), kExact) << name;
    }
}

//! Any heap of cubes that is a 2-manifold.
TEST(GraphOfMesh, rebuilds_random_heaps_of_cubes_exactly) {
    std::size_t tried = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        std::mt19937 random(seed);
        std::array<bool, 36> solid{};
        for (bool& s : solid) s = random() % 10 < 7;
        const TriangleSoup soup = cubes(4, 3, 3, [&](int x, int y, int z) {
            return solid[static_cast<std::size_t>(x + 4 * y + 12 * z)];
        });
        const MeshReport report = analyze(soup, {.self_intersections = false});
        if (!report.manifold || !report.closed || !report.oriented) continue;
        ++tried;
        EXPECT_LT(volume_error_of_round_trip(soup, {.levels = 4}, "seed " + std::to_string(seed)), kExact);
        if (::testing::Test::HasFailure()) break;
    }
    EXPECT_GT(tried, 5u);
}

//! A surface of revolution about z, open where its outline does not come to the axis.
TriangleSoup turned_on_a_lathe(const std::vector<std::pair<double, double>>& outline, std::uint32_t n) {
    TriangleSoup soup;
    for (const auto& [r, z] : outline)
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n;
            soup.points.push_back({r * std::cos(a), 0.8 * r * std::sin(a), z});
        }
    for (std::uint32_t k = 0; k + 1 < outline.size(); ++k)
        for (std::uint32_t i = 0; i < n; ++i)
            shapes::quad(soup, k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n, (k + 1) * n + i);
    return soup;
}

TEST(GraphOfMesh, keeps_open_ends) {
    struct Case {
        std::string name;
        TriangleSoup soup;
        std::size_t loops;
    };
    const TriangleSoup tube = turned_on_a_lathe({{1, 0}, {1.4, 1}, {1.2, 2}, {0.9, 3}}, 24);
    const TriangleSoup cup =
        turned_on_a_lathe({{0.6, 3}, {0.5, 2}, {0.4, 1}, {0.8, 0.9}, {1, 2}, {1, 2.5}}, 24);
    for (const auto& [name, soup, loops] :
         std::vector<Case>{{"tube", tube, 2},
                           {"two tubes in one another",
                            shapes::joined(tube, turned_on_a_lathe({{0.2, 0}, {0.3, 3}}, 12)), 4},
                           {"collar", cup, 2}}) {
        const EnhancedReebGraph graph = graph_of_mesh(half_edge_mesh(soup), {.levels = 12});
        EXPECT_TRUE(faults_of(graph).empty()) << name;
        EXPECT_EQ(std::ranges::count(graph.nodes, NodeForm::Open, &EnhancedNode::form), loops) << name;
        const auto surface = surface_of_graph(graph);
        const MeshReport report = analyze(surface.soup), original = analyze(soup);
        EXPECT_TRUE(report.manifold && report.oriented) << name;
        EXPECT_EQ(report.boundary_loops, loops) << name;
        EXPECT_EQ(report.self_intersections, 0u) << name;
        EXPECT_TRUE(surface.crossings.empty()) << name;
        EXPECT_NEAR(report.area, original.area, 0.02 * original.area) << name;
    }
}

//! A thin plate bent along x and, less, along y: its level sections are slivers, and what is made between two of them crosses itself, until
//! there are contours enough.
TEST(GraphOfMesh, adds_contours_until_the_surface_crosses_itself_nowhere) {
    std::size_t helped = 0;
    for (const auto& [bend, thickness] :
         std::vector<std::pair<double, double>>{{0.5, 0.05}, {2, 0.05}, {0.5, 0.02}}) {
        const TriangleSoup soup = tilted(shapes::terrain_solid(
            8, thickness, [&](double x, double y) { return bend * std::sin(0.9 * x) * std::cos(0.6 * y); }));
        const TriMesh mesh = half_edge_mesh(soup);
        const auto crossings = [&](std::size_t rounds) {
            const auto graph = graph_of_mesh(mesh, {.levels = 2, .crossing_rounds = rounds});
            return analyze(surface_of_graph(graph).soup).self_intersections;
        };
        helped += crossings(0) > 0;
        EXPECT_EQ(crossings(6), 0u) << bend << ", " << thickness << " thick";
    }
    EXPECT_GT(helped, 0u);
}

TEST(GraphOfMesh, refuses_open_contours_and_level_components_with_the_way_out) {
    const auto message = [](const TriangleSoup& soup) {
        try {
            graph_of_mesh(half_edge_mesh(soup));
            return std::string("nothing");
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
    };
    const std::string terrain = message(shapes::terrain(5));
    EXPECT_NE(terrain.find("boundary at"), std::string::npos) << terrain;
    EXPECT_NE(terrain.find("not level"), std::string::npos) << terrain;
    EXPECT_NE(terrain.find("`build`"), std::string::npos) << terrain;
    EXPECT_NE(message(shapes::disc(8, 1)).find("level as a whole"), std::string::npos);
    // A floor with a round hole in it, walls around: the floor goes on at the hole's height.
    TriangleSoup pan = turned_on_a_lathe({{1, 0}, {2, 0}, {2, 1}}, 12);
    EXPECT_NE(message(pan).find("surface goes on"), std::string::npos) << message(pan);
}

TEST(GraphOfMesh, leads_back_to_public_models) {
    const std::string folder = STRATAREEB_SOURCE_DIR "/../shared/data/models/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
    for (const char* name :
         {"3holes_g3", "adis16480_g24", "block_g3", "casting_g9", "doubletorus_g2", "elephant_g3",
          "fertility_g4", "gears_7comp", "knot_g1", "menger1_g5", "menger2_g81", "plate3x3_g9",
          "plate3x3_axis_g9", "rocker-arm_g1", "spot", "torus60x30_g1", "torus60x30_flat_g1", "trimstar_g1"})
        EXPECT_LT(volume_error_of_round_trip(read_mesh(folder + name + ".ply"), {.levels = 20}, name), 0.03)
            << name;
}

}  // namespace
}  // namespace stratareeb
