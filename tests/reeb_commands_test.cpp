// SPDX-License-Identifier: GPL-3.0-or-later
// The commands reeb and levels, and the files that they write.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "boreholes/errors.h"
#include "io/write_contours.h"
#include "io/write_graph.h"
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

TEST_F(ReebCommands, reeb_writes_the_graph_in_three_formats) {
    for (const char* name : {"g.json", "g.dot", "g.graphml"}) {
        const auto command = "reeb " + quoted(torus_) + " --field 1,0.1,0.05 -o " + quoted(file(name));
        EXPECT_EQ(run(command).exit_code, 0) << name;
        EXPECT_EQ(run(command).exit_code, 1) << name << " is there already";
        EXPECT_EQ(run(command + " --overwrite").exit_code, 0) << name;
    }
    const auto json = parsed(file("g.json"));
    ASSERT_EQ(json["nodes"].size(), 4u);
    ASSERT_EQ(json["arcs"].size(), 4u);
    EXPECT_EQ(json["nodes"][0]["type"], "minimum");
    EXPECT_EQ(json["nodes"][3]["type"], "maximum");
    for (const auto& arc : json["arcs"]) EXPECT_LT(arc["from"], arc["to"]);
    EXPECT_EQ(run("reeb " + quoted(torus_) + " -o " + quoted(file("g.xyz"))).exit_code, 1);
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

TEST(WriteGraph, and_contours_refuse_other_formats) {
    EXPECT_THROW(write_graph("graph.txt", {}, TriMesh()), IoError);
    EXPECT_THROW(write_contours("contours.txt", {}), IoError);
}

}  // namespace
}  // namespace stratareeb
