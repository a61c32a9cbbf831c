// SPDX-License-Identifier: GPL-3.0-or-later
// The commands check, convert and info as a user runs them: text, JSON and exit codes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "tests/run_program.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using nlohmann::json;

class MeshCommands : public testing::Test {
 protected:
    MeshCommands() {
        write("cube.ply", {{"cube", {10, 20, 30}, shapes::cube(), {}}});
        write("torus.stl", {{"torus", {}, shapes::torus(3, 1, 24, 12), {}}});
        write("terrain.off", {{"terrain", {}, shapes::terrain(4), {}}});
        write("mobius.ply", {{"mobius", {}, shapes::mobius(20), {}}});
        write("layers.glb", {{"clay", {200, 0, 0}, shapes::slab(4, 4, 1), {}},
                             {"sand", {0, 200, 0}, shapes::moved(shapes::slab(4, 4, 2), 0, 0, 1), {}}});
    }
    void write(const std::string& name, const std::vector<PartData>& parts) {
        write_mesh_parts(folder_ / name, parts);
    }
    ProgramResult run(const std::string& arguments) { return run_program(folder_, arguments); }

    TemporaryFolder folder_;
};

bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST_F(MeshCommands, check_ends_with_0_if_all_are_watertight) {
    const auto result = run("check cube.ply torus.stl");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(says(result.out, "cube.ply: watertight\n")) << result.out;
    EXPECT_TRUE(says(result.out, "torus.stl: watertight\n")) << result.out;
    EXPECT_TRUE(says(result.out, "volume 1, area 6 (input units cubed, squared)")) << result.out;
    EXPECT_TRUE(says(result.out, "genus 1")) << result.out;
    EXPECT_TRUE(says(result.out, "worst triangle: number ")) << result.out;
}

TEST_F(MeshCommands, check_ends_with_1_if_one_is_not_watertight_and_says_why) {
    const auto result = run("check cube.ply terrain.off");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result.out, "cube.ply: watertight\n"));
    EXPECT_TRUE(says(result.out, "terrain.off: NOT watertight\n"));
    EXPECT_TRUE(says(result.out, "problem: 16 edges with a triangle on one side only, first edge 0-1 from "))
        << result.out;
    EXPECT_TRUE(says(result.out, "1 boundary loop\n")) << result.out;
}

TEST_F(MeshCommands, check_json_is_one_list_with_the_promised_keys) {
    const auto result = run("check --json cube.ply mobius.ply torus.stl");
    EXPECT_EQ(result.exit_code, 1);
    const auto list = json::parse(result.out);
    ASSERT_EQ(list.size(), 3u);
    for (const auto& entry : list)
        for (const char* key : {"file", "vertices", "triangles", "components", "genus", "closed", "manifold",
                                "oriented", "self_intersections", "volume", "watertight"})
            EXPECT_TRUE(entry.contains(key)) << key;
    EXPECT_EQ(list[0]["file"], "cube.ply");
    EXPECT_EQ(list[0]["vertices"], 8);
    EXPECT_EQ(list[0]["triangles"], 12);
    EXPECT_EQ(list[0]["watertight"], true);
    EXPECT_DOUBLE_EQ(list[0]["volume"], 1.0);
    EXPECT_TRUE(list[1]["genus"].is_null());
    EXPECT_EQ(list[1]["oriented"], false);
    EXPECT_EQ(list[1]["closed"], false);
    EXPECT_EQ(list[2]["genus"], 1);
}

TEST_F(MeshCommands, check_looks_at_each_part_of_a_file_alone) {
    const auto result = run("check --json layers.glb");  // neighbours touch; each is sound by itself
    EXPECT_EQ(result.exit_code, 0);
    const auto list = json::parse(result.out);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["part"], "clay");
    EXPECT_EQ(list[1]["file"], "layers.glb");
    EXPECT_NEAR(list[1]["volume"].get<double>(), 32.0, 1e-6);
    EXPECT_TRUE(says(run("check layers.glb").out, "layers.glb, part sand: watertight"));
}

TEST_F(MeshCommands, check_goes_on_after_a_file_that_cannot_be_read) {
    folder_.file("junk.ply", "junk");
    const auto result = run("check --json missing.ply junk.ply cube.ply");
    EXPECT_EQ(result.exit_code, 1);
    const auto list = json::parse(result.out);
    ASSERT_EQ(list.size(), 3u);
    EXPECT_TRUE(says(list[0]["error"], "missing.ply: can't be opened"));
    EXPECT_EQ(list[1]["watertight"], false);
    EXPECT_EQ(list[2]["watertight"], true);
    EXPECT_TRUE(says(result.err, "junk.ply:1: not a PLY file")) << result.err;
    EXPECT_EQ(run("check missing.ply").exit_code, 1);
}

TEST_F(MeshCommands, wrong_usage_ends_with_2) {
    for (const char* arguments : {"check", "check --jsno cube.ply", "convert cube.ply", "convert -o a.ply",
                                  "info", "info --depth 3 cube.ply", "nonsense", ""}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << arguments;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_NE(result.err, "") << arguments;
    }
    EXPECT_EQ(run("check --help").exit_code, 0);
}

TEST_F(MeshCommands, convert_writes_every_format) {
    for (const std::string extension : {"ply", "obj", "stl", "off", "glb", "3mf"}) {
        const auto result = run("convert torus.stl -o out." + extension);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, "");
        const auto report = analyze(read_mesh(folder_ / ("out." + extension)));
        EXPECT_TRUE(report.watertight) << extension;
        EXPECT_EQ(report.genus, 1u) << extension;
    }
}

TEST_F(MeshCommands, convert_puts_several_files_into_one_as_parts) {
    EXPECT_EQ(run("convert cube.ply torus.stl layers.glb -o all.3mf").exit_code, 0);
    const auto parts = read_mesh_parts(folder_ / "all.3mf");
    ASSERT_EQ(parts.size(), 4u);
    EXPECT_EQ(parts[0].name, "cube");
    EXPECT_EQ(parts[0].color, (Rgb{10, 20, 30}));
    EXPECT_EQ(parts[1].name, "torus");
    EXPECT_EQ(parts[2].name, "layers clay");
    EXPECT_EQ(parts[3].color, (Rgb{0, 200, 0}));
    EXPECT_EQ(run("convert layers.glb -o layers.obj").exit_code, 0);
    EXPECT_EQ(read_mesh_parts(folder_ / "layers.obj")[1].name, "sand");
}

TEST_F(MeshCommands, convert_leaves_existing_files_unless_told) {
    folder_.file("out.ply", "precious");
    auto result = run("convert cube.ply -o out.ply");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result.err, "out.ply: exists already; add --overwrite")) << result.err;
    EXPECT_EQ(content_of(folder_ / "out.ply"), "precious");
    EXPECT_EQ(run("convert cube.ply -o out.ply --overwrite").exit_code, 0);
    EXPECT_TRUE(analyze(read_mesh(folder_ / "out.ply")).watertight);
    folder_.file("paint.mtl", "precious");
    EXPECT_EQ(run("convert cube.ply -o paint.obj").exit_code, 1);
    EXPECT_EQ(content_of(folder_ / "paint.mtl"), "precious");
}

TEST_F(MeshCommands, convert_fails_with_1_and_leaves_nothing_behind) {
    folder_.file("junk.off", "OFF\n3 1 0\n0 0 0\n");
    const auto files = folder_.size();
    for (const char* arguments : {"convert junk.off -o a.ply", "convert missing.ply -o a.ply",
                                  "convert cube.ply -o a.dae", "convert cube.ply -o missing/a.ply"}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 1) << arguments;
        EXPECT_TRUE(says(result.err, "stratareeb: ")) << arguments;
    }
    EXPECT_EQ(folder_.size(), files);
}

TEST_F(MeshCommands, info_says_what_is_in_a_mesh) {
    const auto text = run("info layers.glb");
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_TRUE(says(text.out, "clay: 8 vertices, 12 triangles, colour #c80000")) << text.out;
    const auto list = json::parse(run("info --json layers.glb cube.ply").out);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["parts"][1]["name"], "sand");
    EXPECT_EQ(list[1]["kind"], "mesh");
    EXPECT_EQ(list[1]["parts"][0]["size"], json({1.0, 1.0, 1.0}));
    EXPECT_EQ(run("info missing.ply cube.ply").exit_code, 1);
    EXPECT_TRUE(says(run("info missing.ply cube.ply").out, "cube.ply: mesh"));
}

TEST_F(MeshCommands, info_says_what_is_in_a_borehole_table) {
    folder_.file("table.csv", "hole,x,y,ground,sand,clay\nA,0,0,10,2,3\nB,100,0,11,0,4\nC,0,50,12,1,\n");
    const auto text = run("info table.csv");
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_TRUE(says(text.out, "table.csv: wide table of 3 boreholes, 2 units")) << text.out;
    EXPECT_TRUE(says(text.out, "  1 sand: in 1 holes, absent from 1, 1 end in it, 0 do not say")) << text.out;
    const auto entry = json::parse(run("info --json table.csv").out)[0];
    EXPECT_EQ(entry["kind"], "boreholes");
    EXPECT_EQ(entry["box"], json({{0.0, 0.0}, {100.0, 50.0}}));
    EXPECT_EQ(entry["units"][1]["holes_unknown"], 1);
}

TEST_F(MeshCommands, info_says_what_is_in_a_model_folder) {
    std::filesystem::create_directory(folder_ / "model");
    folder_.file("model/model.json",
                 R"({"boreholes": 22, "origin": [500000, 5000000, 0], "envelope_volume": 12.5,
        "units": [{"order": 1, "code": "1", "name": "Clay", "volume": 12.5, "components": 2, "genus": 0}],
        "checks": [{"name": "closed", "ok": true}, {"name": "sum", "ok": false}]})");
    const auto text = run("info model").out;
    EXPECT_TRUE(
        says(text, "model: layer model of 22 boreholes, envelope volume 12.5, origin [500000,5000000,0]"))
        << text;
    EXPECT_TRUE(says(text, "  1 Clay: volume 12.5, components 2, genus 0\n")) << text;
    EXPECT_TRUE(says(text, "2 checks, 1 of them failed")) << text;
    EXPECT_EQ(json::parse(run("info --json model").out)[0]["units"][0]["name"], "Clay");
    folder_.file("model/model.json", "{");
    EXPECT_EQ(run("info model").exit_code, 1);
    EXPECT_EQ(run("info .").exit_code, 1);
}

}  // namespace
}  // namespace stratareeb
