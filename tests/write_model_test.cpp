// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_model.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/staged_folder.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

using nlohmann::json;

//! Two layers under a square; the lower one is nowhere.
Survey square_survey() {
    Survey survey;
    survey.units = {{"C", "Clay \"blue\"", "#112233"}, {"S", "Sand", "#445566"}};
    for (const Point2 at : {Point2{0, 0}, Point2{10, 0}, Point2{10, 10}, Point2{0, 10}}) {
        Borehole hole;
        hole.at = at;
        hole.layers = {{Knowledge::Measured, 2}, {Knowledge::Measured, 0}};
        hole.horizons = {5.0, 3.0, 3.0};
        survey.holes.push_back(hole);
    }
    survey.holes[1].layers[1] = {};
    survey.holes[1].horizons[2].reset();
    return survey;
}

ModelRecord record_of(const LayerModel& model, const Survey& survey) {
    ModelRecord record;
    for (std::size_t i = 0; i < model.units.size(); ++i)
        record.units.push_back(summarize_unit(model, build_layer_solid(model, i), survey));
    record.checks = check_model(model, survey, record.units);
    record.warnings = {"row 3: a \"quoted\" word"};
    record.options = {{"spacing", "none"}};
    record.files = {"model.json", "layers/01_Clay_blue.ply"};
    return record;
}

TEST(WriteModel, json_holds_what_checks_rely_on) {
    const Survey survey = square_survey();
    const LayerModel model = build_layer_model(survey, {.spacing = 0.0});
    const json found = json::parse(model_json(model, survey, record_of(model, survey)));
    EXPECT_EQ(found["boreholes"], 4);
    EXPECT_EQ(found["length_unit"], "m");
    EXPECT_EQ(found["origin"], json({0.0, 0.0, 0.0}));
    EXPECT_NEAR(found["envelope_volume"].get<double>(), 200, 1e-9);
    EXPECT_EQ(found["ground"], "horizons/00_ground.ply");
    EXPECT_EQ(found["plan_triangles"], 2);
    EXPECT_EQ(found["warnings"], json({"row 3: a \"quoted\" word"}));
    EXPECT_EQ(found["options"]["spacing"], "none");
    EXPECT_EQ(found["misfit"]["max"], 0.0);
    EXPECT_EQ(found["misfit"]["rms"], 0.0);
    EXPECT_EQ(found["misfit"]["contacts"], 11);
    ASSERT_FALSE(found["checks"].empty());
    for (const auto& check : found["checks"]) {
        EXPECT_EQ(check["ok"], true) << check;
        EXPECT_TRUE(check["name"].is_string() && check["detail"].is_string()) << check;
    }
}

TEST(WriteModel, json_describes_each_unit_from_top_to_bottom) {
    const Survey survey = square_survey();
    const LayerModel model = build_layer_model(survey, {.spacing = 0.0});
    const json units = json::parse(model_json(model, survey, record_of(model, survey)))["units"];
    ASSERT_EQ(units.size(), 2u);
    const json& clay = units[0];
    EXPECT_EQ(clay["order"], 1);
    EXPECT_EQ(clay["code"], "C");
    EXPECT_EQ(clay["name"], "Clay \"blue\"");
    EXPECT_EQ(clay["color"], "#112233");
    EXPECT_NEAR(clay["volume"].get<double>(), 200, 1e-9);
    EXPECT_NEAR(clay["area"].get<double>(), 2 * 100 + 4 * 10 * 2, 1e-9);
    EXPECT_EQ(clay["components"], 1);
    EXPECT_EQ(clay["genus"], 0);
    EXPECT_EQ(clay["solid"], "layers/01_Clay_blue.ply");
    EXPECT_EQ(clay["top"], "horizons/00_ground.ply");
    EXPECT_EQ(clay["base"], "horizons/01_Clay_blue.ply");
    EXPECT_EQ(clay["holes_present"], 4);
    EXPECT_EQ(clay["holes_absent"], 0);
    EXPECT_EQ(clay["holes_unknown"], 0);
}

TEST(WriteModel, json_of_a_layer_that_is_nowhere_has_no_solid_but_its_horizons) {
    const Survey survey = square_survey();
    const LayerModel model = build_layer_model(survey, {.spacing = 0.0});
    const json sand = json::parse(model_json(model, survey, record_of(model, survey)))["units"][1];
    EXPECT_TRUE(sand["solid"].is_null());
    EXPECT_EQ(sand["top"], "horizons/01_Clay_blue.ply");
    EXPECT_EQ(sand["base"], "horizons/02_Sand.ply");
    EXPECT_EQ(sand["volume"], 0.0);
    EXPECT_EQ(sand["components"], 0);
    EXPECT_EQ(sand["holes_absent"], 3);
    EXPECT_EQ(sand["holes_unknown"], 1);
}

TEST(WriteModel, names_files_in_letters_that_any_file_system_takes) {
    EXPECT_EQ(numbered_name(3, "made ground"), "03_made_ground");
    EXPECT_EQ(numbered_name(12, "A-1.b"), "12_A-1.b");
    EXPECT_EQ(numbered_name(100, "x"), "100_x");
    EXPECT_EQ(numbered_name(1, "../../etc/passwd"), "01_.._.._etc_passwd");
    EXPECT_EQ(numbered_name(1, "a / b \\ c : d"), "01_a_b_c_d");
    EXPECT_EQ(numbered_name(1, "dots..."), "01_dots");
    EXPECT_EQ(numbered_name(1, ""), "01_layer");
    EXPECT_EQ(numbered_name(1, "  /// "), "01_layer");
    EXPECT_EQ(numbered_name(1, "น้ำ"), "01_layer");
    EXPECT_EQ(numbered_name(1, "Löß"), "01_L");
    EXPECT_EQ(numbered_name(1, std::string("a\0b\n", 4)), "01_a_b");
    EXPECT_EQ(numbered_name(1, std::string(500, 'x')), "01_" + std::string(60, 'x'));
}

TEST(WriteModel, lists_the_files_of_an_earlier_model) {
    const TemporaryFolder folder;
    folder.file("model.json", R"({"files": ["model.json", 3, "layers/01_a.ply", null]})");
    EXPECT_EQ(listed_files(folder.path() / "model.json"),
              (std::vector<std::string>{"model.json", "layers/01_a.ply"}));
}

TEST(WriteModel, lists_no_files_where_there_is_no_model_or_a_broken_one) {
    const TemporaryFolder folder;
    EXPECT_TRUE(listed_files(folder.path() / "model.json").empty());
    for (const char* text :
         {"", "{", "[]", "{\"files\": 3}", "{\"files\": {\"a\": 1}}", "\xff\xfe", "null"}) {
        folder.file("model.json", text);
        EXPECT_TRUE(listed_files(folder.path() / "model.json").empty()) << text;
    }
}

}  // namespace
}  // namespace stratareeb
