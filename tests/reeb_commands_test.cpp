// SPDX-License-Identifier: GPL-3.0-or-later
// The commands reeb and levels, and the files that they write.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/write_contours.h"
#include "io/write_mesh.h"
#include "tests/run_program.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

class ReebCommands : public ::testing::Test {
 protected:
    ReebCommands() {
        const TriMesh torus = half_edge_mesh(shapes::torus(3, 1, 60, 30));
        write_mesh(torus_, {"torus", "#808080", &torus});
        write_mesh_parts(mobius_, {{.name = "mobius", .soup = shapes::mobius(20), .normals = {}}});
    }

    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    std::string quoted(const std::filesystem::path& path) const { return "'" + path.string() + "'"; }

    TemporaryFolder folder_;
    std::filesystem::path torus_ = folder_.path() / "torus.ply", mobius_ = folder_.path() / "mobius.ply";
};

nlohmann::json parsed(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return nlohmann::json::parse(stream);
}

TEST_F(ReebCommands, reeb_reports_counts_as_json) {
    const auto result = run("reeb " + quoted(torus_) + " --field 1,0.1,0.05 --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["vertices"], 1800);
    EXPECT_EQ(json["triangles"], 3600);
    EXPECT_EQ(json["components"], 1);
    EXPECT_EQ(json["boundary_loops"], 0);
    EXPECT_EQ(json["genus"], 1);
    EXPECT_EQ(json["nodes"], 4);
    EXPECT_EQ(json["arcs"], 4);
    EXPECT_EQ(json["loops"], 1);
    EXPECT_EQ(json["critical"], (nlohmann::json{{"minimum", 1}, {"saddle", 2}, {"maximum", 1}}));
    EXPECT_GE(json["seconds"], 0);
}

TEST_F(ReebCommands, reeb_writes_the_graph_in_every_format) {
    for (const char* name : {"g.json", "g.dot", "g.graphml", "g.ply", "g.obj", "g.svg", "g.pdf", "g.png"}) {
        const auto command = "reeb " + quoted(torus_) + " --field 1,0.1,0.05 -o " + quoted(file(name));
        EXPECT_EQ(run(command).exit_code, 0) << name;
        EXPECT_EQ(run(command).exit_code, 1) << name << " is there already";
        const std::string once = content_of(file(name));
        EXPECT_EQ(run(command + " --overwrite").exit_code, 0) << name;
        EXPECT_EQ(content_of(file(name)), once) << name;
    }
    const auto json = parsed(file("g.json"));
    ASSERT_EQ(json["nodes"].size(), 4u);
    ASSERT_EQ(json["arcs"].size(), 4u);
    EXPECT_EQ(json["nodes"][0]["type"], "minimum");
    EXPECT_EQ(json["nodes"][3]["type"], "maximum");
    for (const auto& arc : json["arcs"]) EXPECT_LT(arc["from"], arc["to"]);
    ASSERT_EQ(json["loops"].size(), 1u);
    EXPECT_EQ(json["loops"][0]["nodes"], (nlohmann::json{1, 2}));
    const auto unknown = run("reeb " + quoted(torus_) + " -o " + quoted(file("g.xyz")));
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_NE(unknown.err.find(".graphml"), std::string::npos);
}

TEST_F(ReebCommands, reeb_colors_the_mesh_and_writes_handles) {
    const auto result = run("reeb " + quoted(torus_) + " --field 1,0.1,0.05 --colored c.ply --loops l.ply");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(read_mesh(file("c.ply")).triangles.size(), 3600u);
    const auto handle = read_mesh(file("l.ply")).triangles.size();
    EXPECT_GT(handle, 500u);
    EXPECT_LT(handle, 1800u);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " --colored c.ply").exit_code, 1);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " --colored c.obj").exit_code, 1);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " --loops l.txt").exit_code, 1);
}

TEST_F(ReebCommands, reeb_collapses_plateaus) {
    // A lying torus: its lowest and highest circles are level.
    const auto fine = nlohmann::json::parse(run("reeb " + quoted(torus_) + " --json").out);
    const auto coarse = nlohmann::json::parse(run("reeb " + quoted(torus_) + " --plateaus --json").out);
    EXPECT_EQ(fine["loops"], 1);
    EXPECT_EQ(coarse["loops"], 1);
    EXPECT_EQ(fine["collapsed"], (nlohmann::json{{"nodes", 2}, {"arcs", 2}}));
    EXPECT_EQ(coarse["collapsed"], fine["collapsed"]);
    EXPECT_EQ(coarse["nodes"], 2);
    EXPECT_EQ(coarse["arcs"], 2);
    EXPECT_GT(fine["nodes"], 2);
}

TEST_F(ReebCommands, reeb_simplifies) {
    const TriMesh terrain = half_edge_mesh(shapes::terrain(40));
    write_mesh(file("t.ply"), {"terrain", "", &terrain});
    const auto count = [&](const std::string& options) {
        const auto result = run("reeb t.ply --json " + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    };
    const auto all = count("--plateaus"), most = count("--simplify 0.1"), least = count("--simplify 0.99");
    EXPECT_EQ(count("--simplify 0")["nodes"], all["nodes"]);
    EXPECT_LT(most["nodes"], all["nodes"]);
    EXPECT_LE(least["nodes"], 2);
    EXPECT_GT(least["simplified"]["pruned_branches"], most["simplified"]["pruned_branches"]);
    EXPECT_EQ(most["nodes"].get<int>() - 1, most["arcs"].get<int>());
    EXPECT_EQ(run("reeb t.ply --simplify 0.1 -o s.svg").exit_code, 0);
    EXPECT_EQ(run("reeb t.ply --simplify 0.1 -o s.ply --colored c.ply").exit_code, 0);
    for (const char* share : {"1", "-0.1", "nan", "some"})
        EXPECT_EQ(run(std::string("reeb t.ply --simplify ") + share).exit_code, 2) << share;
}

TEST_F(ReebCommands, reeb_reports_pairs) {
    const auto result =
        run("reeb " + quoted(torus_) + " --field 1,0.1,0.05 --pairs --json -o " + quoted(file("p.json")));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    ASSERT_EQ(json["pairs"].size(), 2u);
    EXPECT_EQ(json["pairs"][0]["kind"], "component");
    EXPECT_EQ(json["pairs"][1]["kind"], "loop");
    EXPECT_NEAR(json["pairs"][1]["persistence"], 4,
                0.05);  // the hole's width, its direction's length nearly 1
    EXPECT_EQ(parsed(file("p.json"))["pairs"], json["pairs"]);
    EXPECT_NE(run("reeb " + quoted(torus_) + " --pairs").out.find("component"), std::string::npos);
}

TEST_F(ReebCommands, several_meshes_make_a_layered_graph) {
    const TriMesh ball = half_edge_mesh(shapes::uv_sphere(2, 16, 24));
    write_mesh(file("ball.ply"), {"ball", "", &ball});
    const std::string meshes = "torus.ply ball.ply --field 1,0.1,0.05 ";
    const auto result = run("reeb " + meshes + "--json -o l.json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    auto json = nlohmann::json::parse(result.out);
    ASSERT_EQ(json["layers"].size(), 2u);
    EXPECT_EQ(json["layers"][0]["name"], "torus");
    EXPECT_EQ(json["layers"][1]["name"], "ball");
    const auto alone =
        nlohmann::json::parse(run("reeb " + quoted(torus_) + " --field 1,0.1,0.05 --json").out);
    for (const char* key : {"vertices", "triangles", "genus", "nodes", "arcs", "loops", "critical"})
        EXPECT_EQ(json["layers"][0][key], alone[key]) << key;
    EXPECT_EQ(json["nodes"], 6);  // 4 of the torus, 2 of the ball, all at heights of their own
    const auto written = parsed(file("l.json"));
    EXPECT_EQ(written["layers"], (nlohmann::json{"torus", "ball"}));
    EXPECT_EQ(written["nodes"].size(), json["nodes"]);
    EXPECT_EQ(written["arcs"].size(), json["arcs"]);
    EXPECT_EQ(run("reeb " + meshes + "-o l.json").exit_code, 1) << "is there already";
    EXPECT_EQ(run("reeb " + meshes + "-o l.dot").exit_code, 0);
    EXPECT_EQ(run("reeb " + meshes + "-o l.obj").exit_code, 0);
    EXPECT_NE(run("reeb " + meshes).out.find("layered Reeb graph: 6 nodes"), std::string::npos);
}

TEST_F(ReebCommands, layered_graphs_are_simplified_and_named_apart) {
    const TriMesh rough = half_edge_mesh(shapes::terrain(30)), flat = half_edge_mesh(shapes::disc(20, 1));
    std::filesystem::create_directory(file("deep"));
    write_mesh(file("t.ply"), {"terrain", "", &rough});
    write_mesh(file("deep/t.ply"), {"disc", "", &flat});
    const auto json_of = [&](const std::string& options) {
        const auto result = run("reeb t.ply deep/t.ply --json " + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    };
    const auto all = json_of(""), few = json_of("--simplify 0.3");
    EXPECT_EQ(all["layers"][1]["name"], "deep/t.ply");
    EXPECT_LT(few["nodes"], all["nodes"]);
    EXPECT_LT(few["layers"][0]["nodes"], all["layers"][0]["nodes"]);
}

TEST_F(ReebCommands, options_that_do_not_go_together_exit_2) {
    const std::string two = "reeb torus.ply torus.ply ", one = "reeb torus.ply ";
    for (const char* option : {"--colored c.ply", "--loops l.ply", "--pairs", "--enhanced", "--levels 5"})
        EXPECT_EQ(run(two + option).exit_code, 2) << option;
    for (const char* option : {"--colored c.ply", "--loops l.ply", "--pairs", "--plateaus", "--simplify 0.1",
                               "--levels 0", "--tolerance 0", "--field distance:0,0,0", "--field property:z"})
        EXPECT_EQ(run(one + "--enhanced " + option).exit_code, 2) << option;
    for (const char* option : {"--levels 5", "--tolerance 0.1"})
        EXPECT_EQ(run(one + option).exit_code, 2) << option;
    EXPECT_EQ(run(two + "-o l.svg").exit_code, 1);
    EXPECT_EQ(run("reeb torus.ply none.ply").exit_code, 1);
    EXPECT_EQ(run(one + "--enhanced -o g.dot").exit_code, 1);
    EXPECT_EQ(folder_.size(), 2u);  // the two meshes alone
}

TEST_F(ReebCommands, enhanced_graphs_stand_in_turned_coordinates) {
    const auto result = run("reeb torus.ply --enhanced --field 3,0.3,0.15 --levels 12 --json -o g.json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("turned"), std::string::npos);
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["nodes"], 4);
    EXPECT_EQ(json["loops"], 1);
    const auto graph = parsed(file("g.json"));
    ASSERT_EQ(graph["nodes"].size(), 4u);
    EXPECT_EQ(graph["contours"].size(), json["contours"]);
    EXPECT_NE(graph["comment"].get<std::string>().find("(3, 0.3, 0.15) is up"), std::string::npos);
    // Heights are those along the direction: nearly x, whose extremes are -4 and 4; lengths stay.
    EXPECT_NEAR(double(graph["nodes"][0]["position"][2]), -4, 0.05);
    EXPECT_NEAR(double(graph["nodes"][3]["position"][2]), 4, 0.05);
    const auto down = run("reeb torus.ply --enhanced --field=-1,-0.1,-0.05 -o d.json");
    ASSERT_EQ(down.exit_code, 0) << down.err;
    const auto overturned = parsed(file("d.json"));
    for (int n : {0, 3})  // upside down: the mesh looks the same from there, being symmetric
        EXPECT_NEAR(double(overturned["nodes"][n]["position"][2]), double(graph["nodes"][n]["position"][2]),
                    1e-9);
    ASSERT_EQ(
        run("reeb torus.ply --enhanced --field 3,0.3,0.15 --levels 12 --tolerance 0.01 -o f.json").exit_code,
        0);
    EXPECT_GT(parsed(file("f.json"))["contours"].size(), graph["contours"].size());
    EXPECT_EQ(run("reeb torus.ply --enhanced -o g.json").exit_code, 1) << "is there already";
}

TEST_F(ReebCommands, enhanced_graphs_have_level_parts_and_refuse_open_contours) {
    const TriMesh open = half_edge_mesh(shapes::terrain(10)),
                  tube = half_edge_mesh(shapes::cylinder(12, 1, 2));
    write_mesh(file("open.ply"), {"open", "", &open});
    write_mesh(file("tube.ply"), {"tube", "", &tube});
    const auto lying = run("reeb torus.ply --enhanced --json -o g.json");  // two level rings, below and above
    ASSERT_EQ(lying.exit_code, 0) << lying.err;
    EXPECT_EQ(nlohmann::json::parse(lying.out)["flat_nodes"], 2);
    EXPECT_EQ(parsed(file("g.json"))["nodes"][0]["form"], "flat");
    EXPECT_NE(run("reeb tube.ply --enhanced").out.find("2 nodes where it ends in a boundary"),
              std::string::npos);
    const auto boundary = run("reeb open.ply --enhanced");
    EXPECT_EQ(boundary.exit_code, 1);
    EXPECT_NE(boundary.err.find("open.ply: the mesh has a boundary at"), std::string::npos);
    EXPECT_EQ(run("reeb torus.ply --enhanced --field 0,0,0").exit_code, 1);
}

TEST_F(ReebCommands, fields_come_from_distances_files_and_properties) {
    const auto json_of = [&](const std::string& field) {
        const auto result = run("reeb " + quoted(torus_) + " --json --plateaus --field " + field);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        auto json = nlohmann::json::parse(result.out);
        json.erase("seconds");
        return json;
    };
    std::string values = "height\n";
    for (const Point3& p : read_mesh(torus_).points) values += fmt::format("{}\n", p.z);
    folder_.file("z.csv", values);
    EXPECT_EQ(json_of("file:z.csv"), json_of("z"));
    EXPECT_EQ(json_of("property:z"), json_of("z"));
    // Off the torus's axes, its points nearest to and farthest from a place are one each, with two saddles between.
    EXPECT_EQ(json_of("distance:1,0.3,0.2")["loops"], 1);
    EXPECT_EQ(json_of("distance:20,2,1")["nodes"], 4);

    const auto refusal = [&](const std::string& field, int exit_code) {
        const auto result = run("reeb " + quoted(torus_) + " --field " + field);
        EXPECT_EQ(result.exit_code, exit_code) << field;
        return result.err;
    };
    folder_.file("short.csv", "1\n2\n");
    folder_.file("bad.csv", "1\nnan\nx\n");
    EXPECT_NE(refusal("file:short.csv", 1).find("2 values for a mesh of 1800"), std::string::npos);
    EXPECT_NE(refusal("file:bad.csv", 1).find("bad.csv:3"), std::string::npos);
    EXPECT_NE(refusal("property:quality", 1).find("x, y, z"), std::string::npos);
    refusal("file:none.csv", 1);
    for (const char* field : {"distance:1,2", "distance:", "file:", "property:", "1,2", "1,2,inf"})
        refusal(field, 2);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " --field 0,0,0").exit_code, 1);
}

TEST_F(ReebCommands, repair_cuts_a_moebius_strip_open) {
    const auto refused = run("reeb " + quoted(mobius_));
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.err.find("edge"), std::string::npos);
    EXPECT_NE(refused.err.find("--repair"), std::string::npos);
    const auto repaired = run("reeb " + quoted(mobius_) + " --repair --json");
    ASSERT_EQ(repaired.exit_code, 0) << repaired.err;
    EXPECT_NE(repaired.err.find("2 vertices added"), std::string::npos) << repaired.err;
    const auto json = nlohmann::json::parse(repaired.out);
    EXPECT_EQ(json["triangles"], 40);
    EXPECT_EQ(json["vertices"], 42);
    EXPECT_EQ(json["boundary_loops"], 1);
    EXPECT_EQ(json["loops"], 0);
    const auto levels = run("levels " + quoted(mobius_) + " --repair --count 2 --json");
    EXPECT_EQ(levels.exit_code, 0) << levels.err;
    // Values of the file's vertices go with the copies of them.
    std::string values;
    for (const Point3& p : read_mesh(mobius_).points) values += fmt::format("{}\n", p.z);
    folder_.file("z.txt", values);
    const auto by_file = run("reeb " + quoted(mobius_) + " --repair --json --field file:z.txt");
    ASSERT_EQ(by_file.exit_code, 0) << by_file.err;
    EXPECT_EQ(nlohmann::json::parse(by_file.out)["nodes"], json["nodes"]);
    EXPECT_NE(run("reeb " + quoted(torus_) + " --repair").err.find("nothing to repair"), std::string::npos);
}

TEST_F(ReebCommands, reeb_refuses_what_has_no_orientation_or_is_no_field) {
    const auto mobius = run("reeb " + quoted(mobius_));
    EXPECT_EQ(mobius.exit_code, 1);
    EXPECT_NE(mobius.err.find("mobius.ply"), std::string::npos);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " --field up").exit_code, 2);
    EXPECT_EQ(run("reeb").exit_code, 2);
    EXPECT_EQ(run("reeb nothing.ply").exit_code, 1);
}

TEST_F(ReebCommands, levels_report_and_write_contours) {
    const auto result = run("levels " + quoted(torus_) + " --at 0.5,7 --json -o " + quoted(file("c.json")));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto levels = nlohmann::json::parse(result.out)["levels"];
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0]["z"], 0.5);
    EXPECT_EQ(levels[0]["contours"], 2);
    EXPECT_EQ(levels[0]["closed"], 2);
    EXPECT_NEAR(double(levels[0]["length"]), 12 * std::numbers::pi, 0.1);
    EXPECT_EQ(levels[1]["contours"], 0);
    const auto stack = parsed(file("c.json"))["contours"];
    ASSERT_EQ(stack.size(), 2u);
    EXPECT_EQ(stack[0]["z"], 0.5);
    EXPECT_GE(stack[0]["points"].size(), 60u);
    EXPECT_EQ(run("levels " + quoted(torus_) + " --count 3 -o " + quoted(file("c.obj"))).exit_code, 0);
    EXPECT_GT(std::filesystem::file_size(file("c.obj")), 1000u);
    EXPECT_EQ(run("levels " + quoted(torus_)).exit_code, 2);
    EXPECT_EQ(run("levels " + quoted(torus_) + " --at 1 --count 3").exit_code, 2);
}

TEST(WriteContours, refuses_other_formats) {
    EXPECT_THROW(write_contours("contours.txt", {}), IoError);
}

}  // namespace
}  // namespace stratareeb
