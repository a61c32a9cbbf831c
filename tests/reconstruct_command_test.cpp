// SPDX-License-Identifier: GPL-3.0-or-later
// The command reconstruct, and its way back from what reeb --enhanced and levels write.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/read_enhanced_graph.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "tests/run_program.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class ReconstructCommand : public ::testing::Test {
 protected:
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }

    //! The report of a run that must succeed.
    Json json_of(const std::string& arguments) const {
        const auto result = run(arguments + " --json");
        EXPECT_EQ(result.exit_code, 0) << arguments << "\n" << result.err;
        return Json::parse(result.out, nullptr, false);
    }

    //! A run that must fail with this exit code and leave no file; what it says.
    std::string refusal(const std::string& arguments, int exit_code = 1) const {
        const std::size_t before = folder_.size();
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, exit_code) << arguments << "\n" << result.err;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_EQ(folder_.size(), before) << arguments;
        return result.err;
    }

    void write(const std::string& name, const TriangleSoup& soup) const {
        write_mesh_parts(folder_ / name, {{.name = "shape", .soup = soup, .normals = {}}});
    }

    TemporaryFolder folder_;
};

std::vector<fs::path> example_graphs() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(STRATAREEB_SOURCE_DIR "/examples/graphs"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

//! A report of a sound surface of one graph.
void expect_sound(const Json& report, const std::string& name) {
    EXPECT_TRUE(report["closed"]) << name;
    EXPECT_TRUE(report["manifold"]) << name;
    EXPECT_TRUE(report["oriented"]) << name;
    EXPECT_EQ(report["self_intersections"], 0) << name;
    EXPECT_EQ(report["genus"], report["loops"]) << name;
    EXPECT_GT(report["volume"], 0) << name;
}

TEST_F(ReconstructCommand, example_graphs_come_back_from_their_surfaces) {
    ASSERT_GE(example_graphs().size(), 9u);
    for (const fs::path& graph : example_graphs()) {
        const std::string name = graph.stem().string(), mesh = name + ".ply";
        const Json report = json_of("reconstruct '" + graph.string() + "' -o " + mesh);
        expect_sound(report, name);
        const MeshReport read = analyze(read_mesh(folder_ / mesh));
        EXPECT_TRUE(read.closed && read.manifold && read.oriented) << name;
        EXPECT_EQ(read.self_intersections, 0u) << name;
        EXPECT_EQ(read.vertices, report["vertices"]) << name;
        EXPECT_EQ(read.triangles, report["triangles"]) << name;
        EXPECT_DOUBLE_EQ(read.volume, report["volume"]) << name;
        const Json reeb = json_of("reeb --plateaus " + mesh);
        EXPECT_EQ(reeb["nodes"], report["nodes"]) << name;
        EXPECT_EQ(reeb["arcs"], report["edges"]) << name;
        EXPECT_EQ(reeb["loops"], report["loops"]) << name;
    }
}

TEST_F(ReconstructCommand, meshes_come_back_from_their_enhanced_graphs) {
    struct Case {
        std::string name;
        TriangleSoup soup;
        std::string field;
        int genus;
        double volume;
    };
    const double pi = std::numbers::pi;
    const std::vector<Case> cases = {
        {"sphere", shapes::uv_sphere(2, 24, 36), "z", 0, 4.0 / 3 * pi * 8},
        {"cube", shapes::cube(), "0.3,0.2,1", 0, 1},
        {"torus", shapes::torus(3, 1, 48, 24), "1,0.2,0.1", 1, 6 * pi * pi},
    };
    for (const Case& shape : cases) {
        write(shape.name + ".ply", shape.soup);
        const Json graph = json_of(fmt::format("reeb {0}.ply --enhanced --levels 60 --field {1} -o {0}.json",
                                               shape.name, shape.field));
        EXPECT_EQ(graph["turned"], shape.field != "z");
        const Json back = json_of(fmt::format("reconstruct {0}.json -o {0}_back.ply --turned", shape.name));
        expect_sound(back, shape.name);
        EXPECT_EQ(back["genus"], shape.genus) << shape.name;
        EXPECT_EQ(back["nodes"], graph["nodes"]) << shape.name;
        EXPECT_EQ(back["edges"], graph["arcs"]) << shape.name;
        EXPECT_EQ(back["contours"], graph["contours"]) << shape.name;
        EXPECT_NEAR(double(back["volume"]), shape.volume, 0.03 * shape.volume) << shape.name;
        const Json reeb = json_of("reeb --plateaus " + shape.name + "_back.ply");
        EXPECT_EQ(reeb["loops"], shape.genus) << shape.name;
        EXPECT_EQ(reeb["nodes"], graph["nodes"]) << shape.name;
    }
}

TEST_F(ReconstructCommand, turned_meshes_come_back_to_their_place) {
    TriangleSoup torus = shapes::moved(shapes::torus(3, 1, 96, 48), 100, -50, 20);
    write("torus.ply", torus);
    json_of("reeb torus.ply --enhanced --levels 60 --field -0.3,1,-0.2 -o torus.json");
    json_of("reconstruct torus.json -o back.ply");
    const MeshReport before = analyze(torus), after = analyze(read_mesh(folder_ / "back.ply"));
    EXPECT_TRUE(after.watertight);
    for (const auto& [a, b] : {std::pair{before.box_min, after.box_min}, {before.box_max, after.box_max}}) {
        EXPECT_NEAR(a.x, b.x, 0.05);
        EXPECT_NEAR(a.y, b.y, 0.05);
        EXPECT_NEAR(a.z, b.z, 0.05);
    }
}

TEST_F(ReconstructCommand, level_faces_come_back_exactly) {
    write("plate.ply", shapes::plate_with_holes(2));
    const Json graph = json_of("reeb plate.ply --enhanced --levels 4 -o plate.json");
    EXPECT_EQ(graph["flat_nodes"], 2);
    const Json back = json_of("reconstruct plate.json -o back.ply");
    expect_sound(back, "plate");
    EXPECT_EQ(back["genus"], graph["loops"]);
    EXPECT_NEAR(double(back["volume"]), analyze(shapes::plate_with_holes(2)).volume, 1e-4);
}

TEST_F(ReconstructCommand, open_tubes_come_back_open) {
    const TriangleSoup tube = shapes::cylinder(32, 1, 3);
    write("tube.ply", tube);
    const Json graph = json_of("reeb tube.ply --enhanced --levels 4 -o tube.json");
    EXPECT_EQ(graph["open_nodes"], 2);
    const Json back = json_of("reconstruct tube.json -o back.ply");
    EXPECT_EQ(back["closed"], false);
    EXPECT_EQ(back["boundary_loops"], 2);
    EXPECT_EQ(back["manifold"], true);
    EXPECT_NEAR(double(back["area"]), analyze(tube, {.self_intersections = false}).area, 1e-4);
    const ProgramResult text = run("reconstruct tube.json -o again.ply");
    EXPECT_NE(text.out.find("open at 2 ends"), std::string::npos) << text.out;
    write("disc.ply", shapes::terrain(4));
    EXPECT_NE(refusal("reeb disc.ply --enhanced").find("not level"), std::string::npos);
}

TEST_F(ReconstructCommand, torus_comes_back_from_its_contours) {
    write("torus.ply", shapes::torus(3, 1, 60, 30));
    ASSERT_EQ(run("reeb torus.ply --enhanced --field 1,0.1,0.05 -o turned.json").exit_code, 0);
    ASSERT_EQ(run("reconstruct turned.json -o turned.ply --turned").exit_code, 0);  // standing upright
    ASSERT_EQ(run("levels turned.ply --count 30 -o stack.json").exit_code, 0);
    const Json report = json_of("reconstruct stack.json -o back.ply --graph graph.json");
    expect_sound(report, "torus");
    EXPECT_EQ(report["genus"], 1);
    EXPECT_EQ(report["stack"], (Json{{"levels", 30}, {"not_joined", 0}}));
    EXPECT_NEAR(double(report["volume"]), 6 * std::numbers::pi * std::numbers::pi, 2);
    const EnhancedReebGraph graph = read_enhanced_graph(folder_ / "graph.json");
    EXPECT_EQ(graph.nodes.size(), report["nodes"]);
    EXPECT_EQ(loops_of(graph), 1u);
    // The graph that was found is one that a surface can be made of.
    const Json again = json_of("reconstruct graph.json -o again.ply");
    EXPECT_EQ(again["triangles"], report["triangles"]);
    EXPECT_EQ(content_of(folder_ / "again.ply"), content_of(folder_ / "back.ply"));
}

TEST_F(ReconstructCommand, shipped_contours_make_a_mountain) {
    const std::string file = "'" STRATAREEB_SOURCE_DIR "/examples/st_helens/contours.json'";
    const Json report = json_of("reconstruct " + file + " -o mountain.ply");
    expect_sound(report, "St. Helens");
    EXPECT_EQ(report["stack"]["levels"], 22);
    EXPECT_EQ(report["contours"], 25);
    EXPECT_NEAR(double(report["volume"]), 1.29e10, 0.02e10);  // area times spacing
}

TEST_F(ReconstructCommand, options_change_the_surface) {
    const std::string torus = "'" STRATAREEB_SOURCE_DIR "/examples/graphs/torus.json' ";
    const Json plain = json_of("reconstruct " + torus + "-o a.ply");
    const Json finer = json_of("reconstruct " + torus + "-o b.ply --steps 12 --samples 200");
    EXPECT_GT(finer["triangles"], plain["triangles"]);
    const Json linear = json_of("reconstruct " + torus + "-o c.ply --homotopy linear");
    EXPECT_NE(linear["volume"], plain["volume"]);
    for (const char* name : {"parabola", "quadrant", "cardinal", "catmull-rom", "natural-cubic"})
        expect_sound(json_of(fmt::format("reconstruct {}-o {}.ply --homotopy {}", torus, name, name)), name);
    const Json greedy = json_of("reconstruct " + torus + "-o d.ply --fairing off --triangulation greedy");
    const Json exact = json_of("reconstruct " + torus + "-o e.ply --fairing off --triangulation exact");
    EXPECT_EQ(greedy["triangles"], exact["triangles"]);
    EXPECT_LE(double(exact["area"]), double(greedy["area"]) * (1 + 1e-12));
    for (const char* extension : {"obj", "stl", "off", "glb", "3mf"}) {
        const std::string name = fmt::format("f.{}", extension);
        json_of("reconstruct " + torus + "-o " + name);
        EXPECT_EQ(read_mesh(folder_ / name).triangles.size(), plain["triangles"]) << name;
    }
    EXPECT_EQ(run("reconstruct " + torus + "-o g.ply --picture g.png").exit_code, 0);
    EXPECT_GT(fs::file_size(folder_ / "g.png"), 5000u);
}

TEST_F(ReconstructCommand, ply_has_averaged_normals) {
    const std::string torus = "'" STRATAREEB_SOURCE_DIR "/examples/graphs/torus.json' ";
    json_of("reconstruct " + torus + "-o a.ply");
    EXPECT_NE(content_of(folder_ / "a.ply").substr(0, 1000).find("property double nx"), std::string::npos);
}

const char* const kColumn = R"({"contours": [
    {"z": 1, "points": [[0, 0], [2, 0], [2, 2], [0, 2]]},
    {"z": 2, "points": [[0, 0], [0, 2], [2, 2], [2, 0]]}]})";

TEST_F(ReconstructCommand, stacks_take_options) {
    folder_.file("stack.json", kColumn);
    const Json domes = json_of("reconstruct stack.json -o a.ply");
    const Json flat = json_of("reconstruct stack.json -o b.ply --ends flat");
    EXPECT_NEAR(double(flat["volume"]), 8, 1e-9);  // half a spacing more on both sides
    EXPECT_NE(domes["volume"], flat["volume"]);
    const Json spaced = json_of("reconstruct stack.json -o c.ply --ends flat --end-spacing 0.5");
    EXPECT_NEAR(double(spaced["volume"]), 6, 1e-9);
    const Json apart = json_of("reconstruct stack.json -o d.ply --most-spacing 0.5 --end-spacing 0.5");
    EXPECT_EQ(apart["components"], 2);
    folder_.file("two.csv",
                 "roi,ring,depth_code,x,y\n"
                 "a,1,1,0,0\na,1,1,2,0\na,1,1,2,2\na,1,1,0,2\na,2,2,0,0\na,2,2,2,0\na,2,2,2,2\na,2,2,0,2\n"
                 "b,3,1,0,0\nb,3,1,4,0\nb,3,1,4,2\nb,3,1,0,2\nb,4,2,0,0\nb,4,2,4,0\nb,4,2,4,2\nb,4,2,0,2\n");
    const Json part = json_of("reconstruct two.csv --elevation depth_code --part b --ends flat -o e.ply");
    EXPECT_NEAR(double(part["volume"]), 16, 1e-9);
    EXPECT_NE(refusal("reconstruct two.csv --elevation depth_code -o f.ply").find("a, b"), std::string::npos);
}

TEST_F(ReconstructCommand, errors_leave_no_file) {
    EXPECT_NE(refusal("reconstruct none.json -o a.ply").find("none.json"), std::string::npos);
    folder_.file("broken.json", "{\"nodes\": [");
    refusal("reconstruct broken.json -o a.ply");
    folder_.file("mesh.json", "{\"meshes\": []}");
    EXPECT_NE(refusal("reconstruct mesh.json -o a.ply").find("contours"), std::string::npos);
    folder_.file("empty.json", "{\"contours\": []}");
    EXPECT_NE(refusal("reconstruct empty.json -o a.ply").find("empty.json"), std::string::npos);
    folder_.file("crossing.json", R"({"contours": [
        {"z": 1, "points": [[0, 0], [2, 0], [2, 2], [0, 2]]},
        {"z": 1, "points": [[1, 1], [3, 1], [3, 3], [1, 3]]},
        {"z": 2, "points": [[0, 0], [2, 0], [2, 2], [0, 2]]}]})");
    EXPECT_NE(refusal("reconstruct crossing.json -o a.ply").find("contours[1]"), std::string::npos);
    folder_.file("stack.json", kColumn);
    EXPECT_NE(refusal("reconstruct stack.json -o a.xyz").find(".ply"), std::string::npos);
    refusal("reconstruct stack.json -o a.ply --graph g.txt");
    refusal("reconstruct stack.json -o a.ply --picture g.svg");
    refusal("reconstruct stack.json -o nowhere/a.ply");
}

TEST_F(ReconstructCommand, wrong_usage_exits_2) {
    folder_.file("stack.json", kColumn);
    const std::string torus = "'" STRATAREEB_SOURCE_DIR "/examples/graphs/torus.json' ";
    refusal("reconstruct", 2);
    refusal("reconstruct stack.json", 2);
    refusal("reconstruct stack.json -o a.ply --homotopy cubic", 2);
    refusal("reconstruct stack.json -o a.ply --triangulation quick", 2);
    refusal("reconstruct stack.json -o a.ply --steps 0", 2);
    refusal("reconstruct stack.json -o a.ply --samples 2", 2);
    refusal("reconstruct stack.json -o a.ply --end-spacing -1", 2);
    EXPECT_NE(refusal("reconstruct " + torus + "-o a.ply --ends flat", 2).find("--ends"), std::string::npos);
    refusal("reconstruct " + torus + "-o a.ply --elevation z", 2);
    refusal("reconstruct " + torus + "-o a.ply --graph g.json", 2);
}

TEST_F(ReconstructCommand, other_graphs_say_what_makes_the_right_one) {
    write("torus.ply", shapes::torus(3, 1, 48, 24));
    ASSERT_EQ(run("reeb torus.ply --field 1,0.2,0.1 -o plain.json").exit_code, 0);
    EXPECT_NE(refusal("reconstruct plain.json -o a.ply").find("--enhanced"), std::string::npos);
}

TEST_F(ReconstructCommand, overwrites_only_when_asked) {
    folder_.file("stack.json", kColumn);
    for (const char* taken : {"a.ply", "g.json", "p.png", "a.mtl"}) folder_.file(taken, "mine");
    EXPECT_NE(refusal("reconstruct stack.json -o a.ply").find("--overwrite"), std::string::npos);
    refusal("reconstruct stack.json -o b.ply --graph g.json");
    refusal("reconstruct stack.json -o b.ply --picture p.png");
    refusal("reconstruct stack.json -o a.obj");
    for (const char* taken : {"a.ply", "g.json", "p.png", "a.mtl"})
        EXPECT_EQ(content_of(folder_ / taken), "mine");
    json_of("reconstruct stack.json -o a.ply --graph g.json --overwrite");
    EXPECT_GT(read_mesh(folder_ / "a.ply").triangles.size(), 0u);
    EXPECT_EQ(read_enhanced_graph(folder_ / "g.json").contours.size(), 2u);
}

//! Two stems that lean towards each other between two levels: they meet, whatever the homotopy.
const char* const kCrossing = R"({"nodes": [
    {"id": "a", "position": [0, 0, 0]}, {"id": "b", "position": [6, 0, 5]},
    {"id": "c", "position": [6, 0, 0]}, {"id": "d", "position": [0, 0, 5]}],
    "contours": [
    {"id": 1, "type": "circle", "z": 1, "center": [0, 0], "radius": 1},
    {"id": 2, "type": "circle", "z": 4, "center": [6, 0], "radius": 1},
    {"id": 3, "type": "circle", "z": 1, "center": [6, 0], "radius": 1},
    {"id": 4, "type": "circle", "z": 4, "center": [0, 0], "radius": 1}],
    "edges": [{"from": "a", "to": "b", "contours": [1, 2]}, {"from": "c", "to": "d", "contours": [3, 4]}]})";

TEST_F(ReconstructCommand, surfaces_that_cross_are_named_and_kept_back) {
    folder_.file("crossing.json", kCrossing);
    const std::string told = refusal("reconstruct crossing.json -o a.ply");
    for (const char* word : {"contour 1", "contour 2", "contour 3", "contour 4", "--allow-crossings"})
        EXPECT_NE(told.find(word), std::string::npos) << told;
    const Json report = json_of("reconstruct crossing.json -o a.ply --allow-crossings");
    EXPECT_GT(report["self_intersections"], 0);
    EXPECT_TRUE(fs::exists(folder_ / "a.ply"));
}

}  // namespace
}  // namespace stratareeb
