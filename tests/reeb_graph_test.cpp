// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/reeb_graph.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <map>
#include <random>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/analysis.h"
#include "reeb/arc_index.h"
#include "tests/reeb_oracle.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using testing::OracleGraph;
using testing::ReebOracle;

OracleGraph as_oracle(const ReebGraph& graph) {
    OracleGraph result;
    for (const auto& node : graph.nodes) result.nodes.emplace_back(node.vertex, node.down, node.up);
    for (const auto& arc : graph.arcs)
        result.arcs.emplace_back(graph.nodes[arc.lower].vertex, graph.nodes[arc.upper].vertex);
    std::sort(result.nodes.begin(), result.nodes.end());
    std::sort(result.arcs.begin(), result.arcs.end());
    return result;
}

//! Small meshes of many kinds: closed, of genus 0 to 9, open, with several boundaries, in several pieces.
std::vector<std::pair<std::string, TriMesh>> small_meshes() {
    std::vector<std::pair<std::string, TriMesh>> meshes;
    const auto add = [&](const std::string& name, const TriangleSoup& soup) {
        meshes.emplace_back(name, half_edge_mesh(soup));
    };
    add("tetrahedron", shapes::tetrahedron());
    add("cube", shapes::cube());
    add("sphere", shapes::uv_sphere(1, 4, 6));
    add("torus", shapes::torus(3, 1, 6, 4));
    add("double torus", shapes::double_torus());
    const auto row_of_holes = [](std::uint32_t holes) {
        return shapes::plate(2 * holes + 1, 3, [](auto i, auto j) { return i % 2 == 1 && j == 1; });
    };
    add("plate of genus 3", row_of_holes(3));
    add("plate of genus 4", shapes::plate_with_holes(2));
    add("plate of genus 5", row_of_holes(5));
    add("plate of genus 9", shapes::plate_with_holes(3));
    add("disc", shapes::disc(8, 1));
    add("annulus", shapes::annulus(7, 1, 2));
    add("cylinder", shapes::cylinder(6, 1, 2));
    add("terrain", shapes::terrain(6));
    add("sphere and torus",
        shapes::joined(shapes::uv_sphere(1, 4, 5), shapes::moved(shapes::torus(3, 1, 5, 4), 9, 0, 0)));
    add("disc and tetrahedron",
        shapes::joined(shapes::disc(6, 1), shapes::moved(shapes::tetrahedron(), 5, 0, 0)));
    return meshes;
}

//! Cut some triangles out of a mesh, so that it has boundaries of all forms but stays a 2-manifold.
TriangleSoup with_windows(const TriangleSoup& soup, std::mt19937_64& random) {
    TriangleSoup cut{.points = soup.points, .triangles = {}};
    for (const auto& t : soup.triangles)
        if (random() % 8) cut.triangles.push_back(t);
    return cut;
}

TEST(ReebGraph, agrees_with_the_definition_on_thousands_of_random_fields) {
    std::mt19937_64 random(11);
    int compared = 0;
    for (const auto& [name, mesh] : small_meshes()) {
        const int rounds = mesh.n_vertices() > 60 ? 40 : 200;
        for (int round = 0; round < rounds; ++round) {
            ScalarField field(mesh.n_vertices());
            const std::uint64_t range = round % 3 == 0   ? 3
                                        : round % 3 == 1 ? 8
                                                         : 1'000'000;  // ties, some, hardly any
            for (double& value : field) value = static_cast<double>(random() % range);
            const OracleGraph expected = ReebOracle(mesh, field).graph(),
                              found = as_oracle(reeb_graph(mesh, field));
            ASSERT_EQ(found.nodes, expected.nodes) << name << ", round " << round;
            ASSERT_EQ(found.arcs, expected.arcs) << name << ", round " << round;
            ++compared;
        }
    }
    EXPECT_GE(compared, 2000);
}

TEST(ReebGraph, agrees_with_the_definition_on_multiply_connected_open_surfaces) {
    std::mt19937_64 random(12);
    int compared = 0;
    for (int round = 0; compared < 400; ++round) {
        const auto soup = with_windows(round % 2 ? shapes::terrain(6) : shapes::torus(3, 1, 7, 5), random);
        if (!analyze(soup).manifold) continue;
        const TriMesh mesh = half_edge_mesh(soup);
        ScalarField field(mesh.n_vertices());
        for (double& value : field) value = static_cast<double>(random() % (round % 4 ? 1'000'000 : 4));
        const OracleGraph expected = ReebOracle(mesh, field).graph(),
                          found = as_oracle(reeb_graph(mesh, field));
        ASSERT_EQ(found.nodes, expected.nodes) << "round " << round;
        ASSERT_EQ(found.arcs, expected.arcs) << "round " << round;
        ++compared;
    }
}

TEST(ReebGraph, has_as_many_loops_as_the_closed_surface_has_handles) {
    std::mt19937_64 random(13);
    for (const auto& shape : shapes::solids()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        const MeshReport report = analyze(shape.soup);
        for (int round = 0; round < 10; ++round) {
            ScalarField field = height_field(mesh, {1, 0.3, 0.1});
            if (round > 0)
                for (double& value : field) value = static_cast<double>(random() % 50);
            const ReebGraph graph = reeb_graph(mesh, field);
            EXPECT_EQ(graph.loops(), report.genus) << shape.name;
            EXPECT_EQ(graph.components, report.components) << shape.name;
        }
    }
}

// Arcs are what lies between nodes: along an edge of the mesh, the arc changes only by way of a node.
TEST(ReebGraph, knows_the_arc_of_every_vertex) {
    std::mt19937_64 random(14);
    for (const auto& [name, mesh] : small_meshes()) {
        ScalarField field(mesh.n_vertices());
        for (double& value : field) value = static_cast<double>(random() % 1'000'000);
        const ReebGraph graph = reeb_graph(mesh, field);
        for (std::uint32_t v = 0; v < field.size(); ++v) {
            ASSERT_LT(graph.vertex_arc[v], graph.arcs.size()) << name;
            const ReebArc& arc = graph.arcs[graph.vertex_arc[v]];
            EXPECT_LE(graph.nodes[arc.lower].value, field[v]) << name;
            EXPECT_GE(graph.nodes[arc.upper].value, field[v]) << name;
        }
    }
}

// The contour just below a triangle's middle vertex crosses the edge from the lowest to it: that contour's arc is the triangle's.
TEST(ReebGraph, knows_the_arc_of_every_triangle) {
    std::mt19937_64 random(15);
    for (const auto& [name, mesh] : small_meshes()) {
        ScalarField field(mesh.n_vertices());
        for (double& value : field) value = static_cast<double>(random() % 1'000'000'000);
        const ReebGraph graph = reeb_graph(mesh, field);
        ASSERT_EQ(graph.triangle_arc.size(), mesh.n_faces());
        const ArcIndex index(mesh, field, graph);
        for (const auto face : mesh.faces()) {
            std::vector<std::pair<double, TriMesh::Point>> corners;
            for (const auto v : mesh.fv_range(face))
                corners.emplace_back(field[static_cast<std::size_t>(v.idx())], mesh.point(v));
            std::ranges::sort(corners, {}, &std::pair<double, TriMesh::Point>::first);
            const double level = corners[1].first - 0.5;  // values are whole and differ
            const double share = (corners[1].first - level) / (corners[1].first - corners[0].first);
            const auto crossing = corners[1].second + share * (corners[0].second - corners[1].second);
            const Contour contour =
                index.contour(graph.triangle_arc[static_cast<std::size_t>(face.idx())], level);
            EXPECT_NE(std::ranges::find(contour.points, Point3{crossing[0], crossing[1], crossing[2]}),
                      contour.points.end())
                << name;
        }
    }
}

TEST(ReebGraph, is_the_same_on_any_number_of_threads) {
    std::mt19937_64 random(16);
    const TriMesh mesh = half_edge_mesh(shapes::terrain(300));
    ScalarField field(mesh.n_vertices());
    for (double& value : field) value = static_cast<double>(random() % 10'000);
    std::vector<ReebGraph> graphs;
    for (const std::size_t threads : {1u, 2u, 5u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        graphs.push_back(reeb_graph(mesh, field));
    }
    for (const ReebGraph& graph : graphs) {
        EXPECT_EQ(as_oracle(graph).nodes, as_oracle(graphs[0]).nodes);
        EXPECT_EQ(graph.vertex_arc, graphs[0].vertex_arc);
        EXPECT_EQ(graph.triangle_arc, graphs[0].triangle_arc);
    }
}

struct Counts {
    std::size_t nodes, arcs, leaves, loops;
};

// As two independent implementations report them (TTK's FTR graph and a repaired vtkReebGraph), for height z.
TEST(ReebGraph, of_test_models_has_the_published_counts) {
    const std::map<std::string, Counts> expected{{"3holes_g3", {96, 98, 46, 3}},
                                                 {"adis16480_g24", {96, 119, 25, 24}},
                                                 {"amo", {48, 47, 25, 0}},
                                                 {"beetle_11holes", {40, 49, 11, 10}},
                                                 {"block_g3", {124, 126, 60, 3}},
                                                 {"bunny_5holes", {206, 208, 101, 3}},
                                                 {"camelhead_1hole", {18, 17, 10, 0}},
                                                 {"casting_g9", {130, 138, 57, 9}},
                                                 {"doubletorus_g2", {6, 7, 2, 2}},
                                                 {"elephant_g3", {102, 104, 49, 3}},
                                                 {"face_1hole", {30, 29, 16, 0}},
                                                 {"fertility_g4", {42, 45, 18, 4}},
                                                 {"gears_7comp", {435, 430, 224, 2}},
                                                 {"igea", {96, 95, 49, 0}},
                                                 {"knot_g1", {8, 8, 4, 1}},
                                                 {"lucy100k", {154, 153, 78, 0}},
                                                 {"menger1_g5", {10, 14, 2, 5}},
                                                 {"menger2_g81", {122, 202, 2, 81}},
                                                 {"plate3x3_axis_g9", {20, 28, 2, 9}},
                                                 {"plate3x3_g9", {20, 28, 2, 9}},
                                                 {"rocker-arm_g1", {48, 48, 24, 1}},
                                                 {"spot", {12, 11, 7, 0}},
                                                 {"terrain129_disk", {1035, 1034, 536, 0}},
                                                 {"torus60x30_flat_g1", {4, 4, 2, 1}},
                                                 {"torus60x30_g1", {4, 4, 2, 1}},
                                                 {"trimstar_g1", {26, 26, 13, 1}}};
    const std::string folder = STRATAREEB_SOURCE_DIR "/../shared/data/models/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
    for (const auto& [name, counts] : expected) {
        const TriMesh mesh = half_edge_mesh(read_mesh(folder + name + ".ply"));
        const ReebGraph graph = reeb_graph(mesh, height_field(mesh));
        std::size_t leaves = 0;
        for (const auto& node : graph.nodes) leaves += node.down + node.up == 1;
        EXPECT_EQ(graph.loops(), counts.loops) << name;
        EXPECT_EQ(leaves, counts.leaves) << name;
        EXPECT_EQ(graph.nodes.size(), counts.nodes) << name;
        EXPECT_EQ(graph.arcs.size(), counts.arcs) << name;
    }
}

TEST(ReebGraph, of_nothing_and_of_a_field_that_does_not_fit) {
    EXPECT_TRUE(reeb_graph(TriMesh(), {}).nodes.empty());
    EXPECT_THROW(reeb_graph(half_edge_mesh(shapes::cube()), ScalarField(2)), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
