// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_of_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/analysis.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/graph_conditions.h"
#include "reeb/surface_construction.h"
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
double volume_error_of_round_trip(const TriangleSoup& soup, const MeshGraphOptions& options,
                                  const std::string& name) {
    const TriMesh mesh = half_edge_mesh(soup);
    const ReebGraph before = reeb_graph(mesh, height_field(mesh));
    const EnhancedReebGraph graph = graph_of_mesh(mesh, options);
    EXPECT_TRUE(faults_of(graph).empty())
        << name << ": " << (faults_of(graph).empty() ? "" : faults_of(graph)[0]);
    const auto surface = construct_surface(graph, {.steps = 3, .avoid_crossings = false});
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

TEST(GraphOfMesh, refuses_boundaries_and_plateaus_with_their_place) {
    const auto message = [](const TriangleSoup& soup) {
        try {
            graph_of_mesh(half_edge_mesh(soup));
            return std::string("nothing");
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
    };
    EXPECT_NE(message(shapes::disc(8, 1)).find("boundary at"), std::string::npos);
    const auto plate = message(shapes::plate_with_holes(2));
    EXPECT_NE(plate.find("plateau at"), std::string::npos) << plate;
    EXPECT_NE(plate.find("tilted direction"), std::string::npos) << plate;
}

TEST(GraphOfMesh, leads_back_to_public_models) {
    const std::string folder = STRATAREEB_SOURCE_DIR "/../shared/data/models/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
    for (const char* name :
         {"3holes_g3", "adis16480_g24", "block_g3", "doubletorus_g2", "elephant_g3", "fertility_g4",
          "knot_g1", "menger1_g5", "menger2_g81", "plate3x3_g9", "plate3x3_axis_g9", "rocker-arm_g1", "spot",
          "torus60x30_g1", "torus60x30_flat_g1", "trimstar_g1"})
        EXPECT_LT(volume_error_of_round_trip(tilted(read_mesh(folder + name + ".ply")), {.levels = 20}, name),
                  0.03)
            << name;
}

}  // namespace
}  // namespace stratareeb
