// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/run_program.h"

namespace stratareeb {
namespace {

using Json = nlohmann::json;

const std::string kThesis = STRATAREEB_SOURCE_DIR "/examples/thesis_sample3.csv";
const std::string kGlasgow = STRATAREEB_SOURCE_DIR "/examples/sighthill/wide_noheader.csv";

TEST(ValidateCommand, tells_errors_of_every_layer) {
    const TemporaryFolder folder;
    const auto run = run_program(
        folder, "validate '" + kThesis + "' --interpolator linear --bare --pinch-out at-hole --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["boreholes"], 56);
    EXPECT_EQ(json["hold_out"]["way"], "10 folds, seed 1");
    const Json& linear = json["interpolators"][0];
    // The figures of another program for the same folds (tests/hold_out_test.cpp).
    EXPECT_NEAR(linear["layers"][0]["inside"]["rmse"].get<double>(), 11.238, 5.1e-5);
    EXPECT_NEAR(linear["layers"][6]["inside"]["mae"].get<double>(), 13.4372, 5.1e-5);
    EXPECT_EQ(linear["crossings"], 0);
    EXPECT_GT(linear["coverage"].get<double>(), 0.93);
    EXPECT_LT(linear["coverage"].get<double>(), 0.97);
}

TEST(ValidateCommand, writes_tables_maps_and_plots) {
    const TemporaryFolder folder;
    const auto run = run_program(
        folder, "validate '" + kGlasgow + "' --interpolator natural,linear --leave-out 5 -o report");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("5 boreholes at a time until 30 % have been out"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("boreholes as units"), std::string::npos);
    EXPECT_NE(run.out.find("further boreholes that would help most"), std::string::npos);
    for (const char* file : {"validation.json", "errors.csv", "residuals.csv", "residuals.geojson",
                             "units.csv", "next_boreholes.csv", "residual_map.svg", "scatter.svg"})
        EXPECT_GT(content_of(folder / ("report/" + std::string(file))).size(), 50u) << file;
    const Json geojson = Json::parse(content_of(folder / "report/residuals.geojson"));
    EXPECT_EQ(geojson["features"][0]["geometry"]["type"], "Point");
    // What is there stays, unless it may be replaced; the same run gives the same bytes.
    const std::string before = content_of(folder / "report/residual_map.svg");
    EXPECT_EQ(run_program(folder, "validate '" + kGlasgow + "' -o report").exit_code, 1);
    EXPECT_EQ(content_of(folder / "report/residual_map.svg"), before);
    EXPECT_EQ(run_program(folder, "validate '" + kGlasgow +
                                      "' --interpolator natural,linear --leave-out 5 -o report --overwrite")
                  .exit_code,
              0);
    EXPECT_TRUE(content_of(folder / "report/residual_map.svg") == before);
}

TEST(ValidateCommand, draws_differ_as_asked) {
    const TemporaryFolder folder;
    const auto left_out = [&](const std::string& options) {
        const auto run = run_program(folder, "validate '" + kThesis + "' --json " + options);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const Json json = Json::parse(run.out);
        return std::pair(json["hold_out"]["draws"].get<int>(), json["hold_out"]["left_out"].get<int>());
    };
    EXPECT_EQ(left_out("--leave-one-out"), std::pair(56, 56));
    EXPECT_EQ(left_out("--folds 4"), std::pair(4, 56));
    EXPECT_EQ(left_out("--leave-out 10"), std::pair(2, 20));
    EXPECT_EQ(left_out("--leave-out 2 --share 5"), std::pair(2, 4));
    const auto first = run_program(folder, "validate '" + kThesis + "' --json --folds 5");
    EXPECT_EQ(first.out, run_program(folder, "validate '" + kThesis + "' --json --folds 5").out);
    EXPECT_NE(first.out, run_program(folder, "validate '" + kThesis + "' --json --folds 5 --seed 2").out);
}

TEST(ValidateCommand, wider_confidence_and_other_quantiles) {
    const TemporaryFolder folder;
    const auto interval = [&](const std::string& options) {
        const auto run = run_program(folder, "validate '" + kThesis + "' --json " + options);
        const Json layer = Json::parse(run.out)["interpolators"][0]["layers"][0];
        return std::pair(layer["bias"]["high"].get<double>() - layer["bias"]["low"].get<double>(),
                         layer["interval"]["mean_half_width"].get<double>());
    };
    const auto usual = interval(""), narrow = interval("--confidence 80"),
               normal = interval("--quantiles normal");
    EXPECT_LT(narrow.first, usual.first);
    EXPECT_LT(narrow.second, usual.second);
    EXPECT_LT(normal.first, usual.first);
    EXPECT_NEAR(normal.first / usual.first, 1.959964 / 2.004045, 1e-6);  // 55 degrees of freedom
}

TEST(ValidateCommand, compares_volumes_with_the_truth) {
    const TemporaryFolder folder;
    for (const char* holes : {"13", "208"})
        ASSERT_EQ(run_program(folder,
                              std::string("sample --holes ") + holes + " --seed 3 -o wells" + holes + ".csv")
                      .exit_code,
                  0);
    const auto run =
        run_program(folder, "validate wells13.csv wells208.csv --truth wells13_truth.json --json -o volumes");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["models"].size(), 2u);
    EXPECT_EQ(json["models"][0]["boreholes"], 13);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(std::abs(json["models"][1]["error_per_cent"][i].get<double>()), 2);
    EXPECT_NE(content_of(folder / "volumes/volumes.csv").find("wells208 (208 holes), error %"),
              std::string::npos);
    const auto text = run_program(folder, "validate wells208.csv --truth wells13_truth.json");
    EXPECT_NE(text.out.find("208 holes"), std::string::npos);
    EXPECT_NE(text.out.find("all"), std::string::npos);
}

TEST(ValidateCommand, auto_names_what_it_chose_and_why) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(folder, "sample --holes 40 --layers 2 -o wells.csv").exit_code, 0);
    const auto run = run_program(folder, "validate wells.csv --interpolator auto,linear --folds 4 -o report");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(content_of(folder / "report/validation.json"));
    const Json& chosen = json["auto"];
    EXPECT_EQ(json["interpolators"][0]["interpolator"], chosen["interpolator"]);
    double least = 1;
    for (const Json& candidate : chosen["candidates"])
        least = std::min(least, candidate["ratio"].get<double>());
    for (const Json& candidate : chosen["candidates"])
        EXPECT_EQ(candidate["ratio"] == least, candidate["interpolator"] == chosen["interpolator"]);
    ASSERT_EQ(chosen["quantities"].size(), 4u);  // two thicknesses, two bases
    EXPECT_EQ(chosen["quantities"][0]["held_out"], 40);
    EXPECT_GT(chosen["quantities"][3]["rmse"]["natural"], 0);
    EXPECT_NE(run.out.find("auto: " + chosen["reason"].get<std::string>()), std::string::npos) << run.out;
    const std::string table = content_of(folder / "report/auto.csv");
    EXPECT_EQ(table.find("quantity,held_out,linear,natural,spline,kriging,kriging-linear,kriging-quadratic"),
              0u)
        << table;
    EXPECT_EQ(std::ranges::count(table, '\n'), 6);
}

TEST(ValidateCommand, predicts_nothing_from_across_a_fault) {
    const TemporaryFolder folder;
    const std::string graben = STRATAREEB_SOURCE_DIR "/examples/graben/";
    const auto worst_horizon = [&](const std::string& options) {
        const auto run = run_program(folder, "validate '" + graben + "holes.csv' --json " + options);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        double worst = 0;
        const Json json = Json::parse(run.out);
        for (const Json& horizon : json["interpolators"][0]["horizons"])
            worst = std::max(worst, horizon["rmse"].get<double>());
        return worst;
    };
    const std::string faults = "--faults '" + graben + "faults.geojson'";
    EXPECT_LT(worst_horizon(faults), 0.5);
    EXPECT_GT(worst_horizon(""), 5) << "the throw is 30";
    EXPECT_LT(worst_horizon(faults + " --interpolator auto"), 0.5);
    EXPECT_EQ(run_program(folder, "validate '" + graben + "holes.csv' --truth t.json " + faults).exit_code,
              2);
}

TEST(ValidateCommand, rules_make_a_buried_valley_predictable) {
    const TemporaryFolder folder;
    const std::string valley = STRATAREEB_SOURCE_DIR "/examples/buried_valley/";
    for (const char* interpolator : {"kriging", "natural"}) {
        const auto rmse_of_gravel = [&](const std::string& options) {
            const auto run = run_program(
                folder, "validate '" + valley + "holes.csv' --json --interpolator " + interpolator + options);
            EXPECT_EQ(run.exit_code, 0) << run.err;
            return Json::parse(run.out)["interpolators"][0]["layers"][1]["rmse"].get<double>();
        };
        EXPECT_LT(rmse_of_gravel(" --rules '" + valley + "units.csv'"), 0.7 * rmse_of_gravel(""));
    }
}

TEST(ValidateCommand, wrong_usage_and_bad_data_have_their_exit_codes) {
    const TemporaryFolder folder;
    const auto exit_code = [&](const std::string& arguments) {
        return run_program(folder, "validate " + arguments).exit_code;
    };
    EXPECT_EQ(exit_code(""), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --folds 1"), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --folds 5 --leave-one-out"), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --share 20"), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --interpolator magic"), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --confidence 100"), 2);
    EXPECT_EQ(exit_code("'" + kThesis + "' --folds 57"), 1);
    EXPECT_EQ(exit_code("nothing.csv"), 1);
    EXPECT_EQ(exit_code("'" + kThesis + "' --truth nothing.json"), 1);
    const auto run = run_program(folder, "validate '" + kThesis + "' --leave-out 56");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("56 of 56 holes left out at a time"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace stratareeb
