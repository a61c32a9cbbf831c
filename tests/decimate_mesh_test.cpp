// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/decimate_mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "mesh/surface_distance.h"
#include "tests/run_program.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

//! Every triangle into four, in its plane.
TriangleSoup split_in_four(const TriangleSoup& soup) {
    TriangleSoup result{soup.points, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const auto [it, fresh] =
            middle.emplace(std::minmax(a, b), static_cast<std::uint32_t>(result.points.size()));
        const Point3 p = soup.points[a], q = soup.points[b];
        if (fresh) result.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
        return it->second;
    };
    for (const auto& [a, b, c] : soup.triangles) {
        const auto ab = between(a, b), bc = between(b, c), ca = between(c, a);
        for (const auto& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            result.triangles.push_back(t);
    }
    return result;
}

TriangleSoup split_in_four(TriangleSoup soup, int times) {
    while (times-- > 0) soup = split_in_four(soup);
    return soup;
}

//! The distance of the surfaces by many more samples than the decimation looks at, both ways.
double dense_distance(const TriMesh& a, const TriMesh& b, double spacing) {
    double largest = 0;
    const TriangleSoup of_a = triangle_soup(a), of_b = triangle_soup(b);
    for (const double d : SurfaceDistance(of_b).of(surface_samples(of_a, spacing)))
        largest = std::max(largest, d);
    for (const double d : SurfaceDistance(of_a).of(surface_samples(of_b, spacing)))
        largest = std::max(largest, d);
    return largest;
}

void expect_same_topology(const TriMesh& before, const TriMesh& after) {
    const MeshReport b = analyze(before), a = analyze(after);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.genus, b.genus);
    EXPECT_EQ(a.boundary_loops, b.boundary_loops);
    EXPECT_EQ(a.watertight, b.watertight) << (a.problems.empty() ? "" : a.problems.front());
    EXPECT_EQ(a.self_intersections, b.self_intersections);
    EXPECT_EQ(a.degenerate_triangles, b.degenerate_triangles);
    EXPECT_EQ(a.unused_vertices, 0u);
}

TEST(SurfaceDistance, is_that_of_plane_edge_and_corner) {
    const SurfaceDistance distance(shapes::cube());
    const auto d = distance.of({{0.5, 0.5, 3}, {0.5, 2, 2}, {2, 2, 2}, {0.5, 0.5, 0.25}, {1, 0.3, 1}});
    const double expected[] = {2, std::sqrt(2), std::sqrt(3), 0.25, 0};
    for (std::size_t i = 0; i < d.size(); ++i) EXPECT_NEAR(d[i], expected[i], 1e-12);
    EXPECT_TRUE(distance.is_within({2, 2, 2}, 1.7321));
    EXPECT_FALSE(distance.is_within({2, 2, 2}, 1.7320));
}

TEST(SurfaceDistance, samples_are_as_dense_as_asked) {
    const auto samples = surface_samples(shapes::tetrahedron(), 0.1);
    for (int i = 0; i <= 50; ++i) {  // along a diagonal edge
        const Point3 p{i / 50.0, 1 - i / 50.0, 0};
        double nearest = 1e9;
        for (const auto& s : samples)
            nearest = std::min(nearest, std::hypot(s.x - p.x, s.y - p.y, s.z - p.z));
        EXPECT_LE(nearest, 0.1);
    }
}

TEST(DecimateMesh, flat_sides_become_the_fewest_triangles) {
    for (const int times : {1, 2, 3}) {
        const TriMesh cube = half_edge_mesh(split_in_four(shapes::cube(), times));
        const auto result = decimate_mesh(cube, {.max_error = 1e-9});
        EXPECT_EQ(result.mesh.n_faces(), 12u);
        EXPECT_NEAR(volume(result.mesh), 1, 1e-12);
        EXPECT_LT(result.deviation, 1e-9);
    }
    const TriMesh tetrahedron = half_edge_mesh(split_in_four(shapes::tetrahedron(), 3));
    EXPECT_EQ(decimate_mesh(tetrahedron, {.triangles = 1}).mesh.n_faces(), 4u) << "and never fewer";
}

TEST(DecimateMesh, solids_keep_topology_and_stay_within_the_error) {
    for (const auto& [name, soup] : shapes::solids()) {
        SCOPED_TRACE(name);
        const TriMesh mesh = half_edge_mesh(split_in_four(soup));
        for (const double error : {0.0, 0.02, 0.1}) {
            const auto result = decimate_mesh(mesh, {.max_error = error});
            expect_same_topology(mesh, result.mesh);
            EXPECT_LE(result.mesh.n_faces(), mesh.n_faces());
            EXPECT_LE(result.deviation, error + 1e-9 * (1 + 5e6));
            EXPECT_LE(dense_distance(mesh, result.mesh, 0.05), 1.05 * error + 1e-9 * (1 + 5e6));
        }
        const auto half = decimate_mesh(mesh, {.triangles = mesh.n_faces() / 2});
        expect_same_topology(mesh, half.mesh);
        EXPECT_TRUE(half.target_reached);
    }
}

TEST(DecimateMesh, open_surfaces_keep_their_boundary) {
    for (const auto& [name, soup] : shapes::open_surfaces()) {
        SCOPED_TRACE(name);
        const TriMesh mesh = half_edge_mesh(split_in_four(soup, 2));
        const auto result = decimate_mesh(mesh, {.max_error = 0.2});
        expect_same_topology(mesh, result.mesh);
        EXPECT_LT(result.mesh.n_faces(), mesh.n_faces());
        double before = 0, after = 0;
        for (const auto e : mesh.edges())
            if (mesh.is_boundary(e)) before += mesh.calc_edge_length(e);
        for (const auto e : result.mesh.edges())
            if (result.mesh.is_boundary(e)) after += result.mesh.calc_edge_length(e);
        EXPECT_NEAR(after, before, 1e-6 * before);
    }
}

TEST(DecimateMesh, a_larger_error_leaves_fewer_triangles) {
    const TriMesh mesh = half_edge_mesh(shapes::torus(3, 1, 96, 48));
    std::size_t last = mesh.n_faces();
    for (const double error : {0.005, 0.02, 0.08}) {
        const auto result = decimate_mesh(mesh, {.max_error = error});
        EXPECT_LT(result.mesh.n_faces(), last);
        last = result.mesh.n_faces();
    }
    EXPECT_LT(last, mesh.n_faces() / 10);
}

TEST(DecimateMesh, thin_shells_do_not_cross) {
    // Two rolling surfaces a twentieth of a cell apart: coarse triangles of one would stick out of the other.
    const auto f = [](double x, double y) { return 1.5 * std::sin(0.9 * x) * std::cos(0.8 * y); };
    const TriMesh mesh = half_edge_mesh(shapes::terrain_solid(40, 0.05, f));
    const auto result = decimate_mesh(mesh, {.triangles = 800});
    expect_same_topology(mesh, result.mesh);
    EXPECT_EQ(result.mesh.n_faces(), 800u);
    const auto fewer = decimate_mesh(mesh, {.triangles = 10});
    expect_same_topology(mesh, fewer.mesh);
}

TEST(DecimateMesh, far_from_the_origin_it_is_as_near_it) {
    const TriMesh near = half_edge_mesh(shapes::uv_sphere(2, 32, 64)),
                  far = half_edge_mesh(shapes::moved(shapes::uv_sphere(2, 32, 64), 5e6, 4e6, 100));
    const auto a = decimate_mesh(near, {.triangles = 400}), b = decimate_mesh(far, {.triangles = 400});
    EXPECT_NEAR(a.deviation, b.deviation, 0.2 * a.deviation);
    EXPECT_NEAR(volume(b.mesh), volume(a.mesh), 0.02 * volume(a.mesh));
}

TEST(DecimateMesh, vertices_are_those_of_the_input_and_results_repeat) {
    const TriMesh mesh = half_edge_mesh(shapes::torus(3, 1, 48, 24));
    std::set<std::array<double, 3>> known;
    for (const auto v : mesh.vertices()) known.insert({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
    const auto first = decimate_mesh(mesh, {.max_error = 0.05}),
               second = decimate_mesh(mesh, {.max_error = 0.05});
    for (const auto v : first.mesh.vertices()) {
        const auto& p = first.mesh.point(v);
        EXPECT_TRUE(known.contains({p[0], p[1], p[2]}));
    }
    EXPECT_EQ(triangle_soup(first.mesh).triangles, triangle_soup(second.mesh).triangles);
    EXPECT_EQ(triangle_soup(first.mesh).points, triangle_soup(second.mesh).points);
}

TEST(DecimateMesh, takes_empty_tiny_and_crossing_meshes_and_refuses_nonsense) {
    EXPECT_EQ(decimate_mesh({}, {.triangles = 1}).mesh.n_faces(), 0u);
    TriangleSoup one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(decimate_mesh(half_edge_mesh(one), {.max_error = 10}).mesh.n_faces(), 1u);
    const auto crossing = half_edge_mesh(
        split_in_four(shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 0.5, 0.5, 0.5)), 2));
    const auto result = decimate_mesh(crossing, {.max_error = 1e-9});
    EXPECT_EQ(result.mesh.n_faces(), 24u);
    EXPECT_NE(result.note.find("the input crosses itself"), std::string::npos);
    const TriMesh cube = half_edge_mesh(shapes::cube());
    EXPECT_THROW(decimate_mesh(cube, {}), InvalidInput);
    EXPECT_THROW(decimate_mesh(cube, {.max_error = -1}), InvalidInput);
    EXPECT_THROW(decimate_mesh(cube, {.triangles = 4, .max_turn_deg = 120}), InvalidInput);
    EXPECT_THROW(decimate_mesh(cube, {.triangles = 4, .min_angle_deg = 90}), InvalidInput);
}

TEST(DecimateMesh, public_models_keep_genus_and_stay_watertight) {
    const std::string data = STRATAREEB_SOURCE_DIR "/../shared/data/models/";
    if (!std::filesystem::exists(data + "README.md")) GTEST_SKIP() << "no data beside the source tree";
    for (const std::string name :
         {"3holes_g3", "spot", "knot_g1", "doubletorus_g2", "fertility_g4", "menger2_g81"}) {
        SCOPED_TRACE(name);
        const TriMesh mesh = half_edge_mesh(read_mesh(data + name + ".ply"));
        const MeshReport report = analyze(mesh, {.self_intersections = false});
        const double size =
            std::hypot(report.box_max.x - report.box_min.x, report.box_max.y - report.box_min.y,
                       report.box_max.z - report.box_min.z);
        const auto result = decimate_mesh(mesh, {.max_error = 0.005 * size});
        expect_same_topology(mesh, result.mesh);
        EXPECT_LT(result.mesh.n_faces(), mesh.n_faces());
        EXPECT_LE(result.deviation, 0.005 * size);
    }
}

TEST(DecimateCommand, writes_the_mesh_and_says_what_was_done) {
    const TemporaryFolder folder;
    write_mesh_parts(folder / "cube.ply", {{"cube", {10, 20, 30}, split_in_four(shapes::cube(), 2), {}}});
    const auto done = run_program(folder, "decimate cube.ply -o small.ply --max-error 1e-6 --json");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const auto json = nlohmann::json::parse(done.out);
    EXPECT_EQ(json["triangles_before"], 192);
    EXPECT_EQ(json["triangles"], 12);
    EXPECT_EQ(read_mesh(folder / "small.ply").triangles.size(), 12u);
    EXPECT_EQ(run_program(folder, "decimate cube.ply -o small.ply --triangles 50").exit_code, 1)
        << "it exists";
    const auto text = run_program(folder, "decimate cube.ply -o small.ply --triangles 50 --overwrite");
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_NE(text.out.find("from 192 to 50 triangles"), std::string::npos) << text.out;
    EXPECT_EQ(run_program(folder, "decimate cube.ply -o x.ply").exit_code, 2);
    EXPECT_EQ(run_program(folder, "decimate cube.ply -o x.ply --max-error -1").exit_code, 2);
    EXPECT_EQ(run_program(folder, "decimate none.ply -o x.ply --triangles 5").exit_code, 1);
}

}  // namespace
}  // namespace stratareeb
