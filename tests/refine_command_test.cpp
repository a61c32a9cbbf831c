// SPDX-License-Identifier: GPL-3.0-or-later
// The command refine as a user runs it: files, text, JSON and exit codes.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "tests/refine_cases.h"
#include "tests/run_program.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using nlohmann::json;

class RefineCommand : public testing::Test {
 protected:
    RefineCommand() {
        write_polygons(folder_ / "cube.obj", "cube", shapes::quad_cube());
        write_polygons(folder_ / "cube.ply", "cube", shapes::quad_cube());
        write_polygons(folder_ / "grid.off", "grid", shapes::quad_grid(4));
        write_polygons(folder_ / "octahedron.ply", "octahedron", shapes::octahedron());
        write_polygons(folder_ / "mobius.ply", "mobius", polygon_mesh(shapes::mobius(20)));
        write_polygons(folder_ / "torus.ply", "torus", polygon_mesh(shapes::torus(3, 1, 24, 12)));
    }
    ProgramResult run(const std::string& arguments) { return run_program(folder_, "refine " + arguments); }
    json run_json(const std::string& arguments) {
        const auto result = run(arguments + " --json");
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out);
    }
    TemporaryFolder folder_;
};

bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST_F(RefineCommand, triangles_are_refined_by_loop_and_polygons_by_catmull_clark) {
    const auto loop = run_json("octahedron.ply -o a.ply --limit");
    EXPECT_EQ(loop["scheme"], "loop");
    EXPECT_EQ(loop["levels"], 2);
    EXPECT_EQ(loop["faces"], 128);
    EXPECT_EQ(loop["vertices"], 66);
    EXPECT_EQ(loop["control"]["faces"], 8);
    EXPECT_EQ(loop["closed"], true);
    const auto mesh = read_mesh(folder_ / "a.ply");
    EXPECT_NEAR(mesh.points[4].z, 24.0 / 55, 1e-15);
    EXPECT_NEAR(loop["volume"].get<double>(), volume(mesh), 1e-15);
    EXPECT_NEAR(loop["area"].get<double>(), area(mesh), 1e-15);

    for (const std::string extension : {"ply", "obj", "off"}) {
        const auto quads = run_json("cube.obj -o b." + extension + " --levels 3");
        EXPECT_EQ(quads["scheme"], "catmull-clark");
        EXPECT_EQ(quads["faces"], 384);
        EXPECT_EQ(quads["quads"], 384);
        EXPECT_EQ(quads["triangles"], 768);
        EXPECT_EQ(read_polygons(folder_ / ("b." + extension)).face_count(), 384u);
    }
    EXPECT_EQ(run_json("cube.ply -o c.stl")["faces"], 96);
    EXPECT_EQ(read_mesh(folder_ / "c.stl").triangles.size(), 192u);
    EXPECT_EQ(run_json("cube.ply -o d.ply --triangles")["quads"], 0);
    EXPECT_EQ(read_polygons(folder_ / "d.ply").face_count(), 192u);
}

TEST_F(RefineCommand, polygons_are_cut_for_loop_and_that_is_said) {
    const auto result = run("cube.ply -o a.ply --scheme loop --levels 1");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(says(result.err, "cube.ply: polygons are cut into triangles for Loop subdivision"))
        << result.err;
    EXPECT_TRUE(says(result.out, "a.ply: 26 vertices, 48 faces (loop from 12 at level 1)\n")) << result.out;
}

TEST_F(RefineCommand, boundary_rules) {
    EXPECT_NEAR(run_json("grid.off -o a.ply --limit --boundary fixed")["area"].get<double>(), 16, 1e-12);
    const auto corners = run_json("grid.off -o b.ply --limit");
    EXPECT_NEAR(corners["area"].get<double>(), 16, 1e-12);
    EXPECT_EQ(corners["corners"], 4);
    EXPECT_TRUE(corners["volume"].is_null());
    const auto smooth = run_json("grid.off -o c.ply --limit --boundary smooth");
    EXPECT_LT(smooth["area"].get<double>(), 15.9);
    EXPECT_EQ(smooth["corners"], 0);
    EXPECT_EQ(run_json("grid.off -o d.ply --corner-angle 100")["corners"], 0);
}

TEST_F(RefineCommand, creases_by_angle_and_by_file) {
    const auto sharp = run_json("cube.ply -o a.ply --crease-angle 30 --limit");
    EXPECT_EQ(sharp["creases"], 12);
    EXPECT_NEAR(sharp["volume"].get<double>(), 8, 1e-12);
    std::ofstream(folder_ / "creases.txt") << "feature base\nline 0 1 2 3 0\nfeature top\nline 4 5 6 7 4\n";
    const auto listed =
        run_json("cube.ply -o b.ply --crease-edges creases.txt --crease-features base --limit");
    EXPECT_EQ(listed["creases"], 4);
    EXPECT_NEAR(analyze(read_mesh(folder_ / "b.ply")).box_min.z, -1, 1e-12);
    EXPECT_LT(analyze(read_mesh(folder_ / "b.ply")).box_max.z, 0.9);
    const auto unknown = run("cube.ply -o c.ply --crease-edges creases.txt --crease-features fault");
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_TRUE(says(unknown.err, "there is no feature fault; there are base, top")) << unknown.err;
    std::ofstream(folder_ / "diagonal.txt") << "0 6\n";
    const auto diagonal = run("cube.ply -o c.ply --crease-edges diagonal.txt");
    EXPECT_EQ(diagonal.exit_code, 1);
    EXPECT_TRUE(
        says(diagonal.err,
             "cube.ply: the crease from vertex 0 at (-1, -1, -1) to vertex 6 at (1, 1, 1) is no edge"))
        << diagonal.err;
}

TEST_F(RefineCommand, adaptive_meshes_are_watertight_and_smaller) {
    const auto adaptive = run_json("torus.ply -o a.ply --adaptive 0.002 --levels 5");
    const auto report = analyze(read_mesh(folder_ / "a.ply"));
    EXPECT_TRUE(report.watertight);
    EXPECT_EQ(report.genus, 1u);
    EXPECT_EQ(adaptive["tolerance"], 0.002);
    EXPECT_EQ(adaptive["limit"], true);
    const int levels = adaptive["levels"];
    EXPECT_GE(levels, 2);
    EXPECT_LT(adaptive["faces"].get<int>(), (24 * 12 * 2) << (2 * levels));
    const auto uniform = run_json("torus.ply -o b.ply --limit --levels 5");
    EXPECT_NEAR(adaptive["volume"].get<double>(), uniform["volume"].get<double>(), 0.002 * 78);
}

TEST_F(RefineCommand, pictures_show_before_and_after) {
    EXPECT_EQ(run("cube.ply -o a.ply --limit --picture a.png").exit_code, 0);
    EXPECT_EQ(content_of(folder_ / "a.png").substr(1, 3), "PNG");
    EXPECT_EQ(run("cube.ply -o b.ply --picture b.jpg").exit_code, 1);
    EXPECT_EQ(run("cube.ply -o b.ply --picture a.png").exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.ply"));
}

TEST_F(RefineCommand, files_that_are_there_stay) {
    std::ofstream(folder_ / "a.ply") << "mine";
    const auto result = run("octahedron.ply -o a.ply");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result.err, "a.ply: is there already")) << result.err;
    EXPECT_EQ(content_of(folder_ / "a.ply"), "mine");
    EXPECT_EQ(run("octahedron.ply -o a.ply --overwrite").exit_code, 0);
    std::ofstream(folder_ / "b.mtl") << "mine";
    EXPECT_EQ(run("octahedron.ply -o b.obj").exit_code, 1);
    EXPECT_EQ(content_of(folder_ / "b.mtl"), "mine");
}

TEST_F(RefineCommand, failures_name_place_and_way_out) {
    const auto mobius = run("mobius.ply -o a.ply");
    EXPECT_EQ(mobius.exit_code, 1);
    EXPECT_TRUE(says(mobius.err, "mobius.ply: edge from vertex ")) << mobius.err;
    EXPECT_TRUE(says(mobius.err, "wound against each other; --repair cuts the mesh there")) << mobius.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ply"));
    EXPECT_EQ(run("mobius.ply -o a.ply --repair").exit_code, 0);
    const auto memory = run("torus.ply -o b.ply --levels 10");
    EXPECT_EQ(memory.exit_code, 1);
    EXPECT_TRUE(says(memory.err, "about 604 million faces need ")) << memory.err;
    EXPECT_TRUE(says(memory.err, "fewer --levels")) << memory.err;
    EXPECT_EQ(run("none.ply -o b.ply").exit_code, 1);
    EXPECT_EQ(run("torus.ply -o b.xyz").exit_code, 1);
}

TEST_F(RefineCommand, wrong_usage_ends_with_2) {
    for (const char* arguments :
         {"", "torus.ply", "torus.ply -o a.ply --levels 0", "torus.ply -o a.ply --scheme butterfly",
          "torus.ply -o a.ply --boundary round", "torus.ply -o a.ply --adaptive 0",
          "torus.ply -o a.ply --crease-angle 200", "torus.ply -o a.ply --crease-features rim"})
        EXPECT_EQ(run(arguments).exit_code, 2) << arguments;
}

}  // namespace
}  // namespace stratareeb
