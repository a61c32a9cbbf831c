// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/csv_table.h"
#include "io/read_boreholes.h"
#include "io/read_true_volumes.h"
#include "io/write_residual_drawing.h"
#include "io/write_validation.h"
#include "mesh/analysis.h"
#include "mesh/layer_solid.h"
#include "mesh/layer_volumes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

Survey pinching_survey(std::size_t holes = 60) {
    return random_survey({.holes = holes,
                          .layers = 4,
                          .seed = 4,
                          .pinch_outs = true,
                          .unknown_share = 0.1,
                          .cut_off_share = 0.2});
}

TEST(Validation, sums_up_what_the_hold_out_found) {
    const Survey survey = pinching_survey();
    const auto draws = fold_draws(60, 10, 1);
    const Validation result = validate(survey, draws);
    const auto held = hold_out(survey, draws);
    ASSERT_EQ(result.layers.size(), 4u);
    ASSERT_EQ(result.horizons.size(), 5u);
    EXPECT_EQ(result.held.size(), 60u);
    EXPECT_EQ(result.crossings, 0u);
    std::size_t values = 0, covered = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const ItemValidation& item = result.layers[i];
        const auto residuals = thickness_residuals(survey, held, i);
        ASSERT_EQ(item.residuals.size(), residuals.size());
        std::vector<double> errors;
        std::size_t present = 0, within = 0;
        for (std::size_t k = 0; k < residuals.size(); ++k) {
            EXPECT_EQ(item.residuals[k].predicted, residuals[k].predicted);
            errors.push_back(residuals[k].error());
            present += (residuals[k].actual > 0) == (residuals[k].predicted > 0);
            within += std::abs(residuals[k].error()) <= item.half_width[k];
        }
        EXPECT_EQ(item.errors.rmse, summarize_errors(errors).rmse);
        EXPECT_EQ(item.bias.low, mean_test(errors).low);
        EXPECT_EQ(item.presence_right, present);
        EXPECT_EQ(item.covered, within);
        EXPECT_EQ(item.bounds.bounds, check_bounds(survey, held, i).bounds);
        values += errors.size();
        covered += within;
    }
    EXPECT_EQ(result.pooled.values, values);
    EXPECT_LE(result.pooled.units, 60u);
    EXPECT_EQ(result.pooled_naive.units, values);
    EXPECT_EQ(result.horizons[0].name, "ground");
    EXPECT_EQ(result.horizons[2].name, "base of " + survey.units[1].name);
    for (const ItemValidation& item : result.horizons) {
        values += item.errors.count;
        covered += item.covered;
    }
    EXPECT_DOUBLE_EQ(result.coverage, static_cast<double>(covered) / static_cast<double>(values));
    EXPECT_EQ(result.next.size(), 5u);
    EXPECT_GT(result.units.share_right(), 0.3);
    EXPECT_LE(result.units.share_right(), 1.0);
}

TEST(Validation, intervals_cover_between_93_and_97_per_cent_for_every_interpolator) {
    const Survey survey = random_survey({.holes = 90, .layers = 3, .seed = 2, .pinch_outs = true});
    for (const InterpolatorKind kind : interpolator_kinds()) {
        ValidationOptions options;
        options.hold_out.prediction.interpolator = kind;
        const Validation result = validate(survey, fold_draws(90, 10, 1), options);
        EXPECT_GT(result.coverage, 0.93) << name_of(kind);
        EXPECT_LT(result.coverage, 0.97) << name_of(kind);
        EXPECT_EQ(result.crossings, 0u) << name_of(kind);
        for (const ItemValidation& item : result.layers)
            EXPECT_TRUE(std::isfinite(item.errors.rmse)) << name_of(kind);
    }
}

TEST(Validation, better_known_ground_is_better_predicted) {
    const auto rmse = [](std::size_t holes) {
        const Survey survey = random_survey({.holes = holes, .layers = 3, .seed = 7});
        return validate(survey, fold_draws(holes, 10, 1)).layers[1].errors.rmse;
    };
    EXPECT_LT(rmse(400), 0.5 * rmse(50));
}

TEST(Validation, reports_hold_the_same_numbers) {
    const Survey survey = pinching_survey();
    const std::vector<NamedValidation> validations{{"natural", validate(survey, fold_draws(60, 5, 1))}};
    const Validation& result = validations[0].result;
    const auto json = validation_json(survey, validations, {.hold_out = "5 folds, seed 1"});
    EXPECT_EQ(json["hold_out"]["draws"], 5);
    const auto& natural = json["interpolators"][0];
    EXPECT_EQ(natural["interpolator"], "natural");
    EXPECT_EQ(natural["layers"][2]["rmse"].get<double>(), result.layers[2].errors.rmse);
    EXPECT_EQ(natural["layers"][2]["code"], survey.units[2].code);
    EXPECT_EQ(natural["horizons"].size(), 5u);
    EXPECT_EQ(natural["next_boreholes"][0]["x"].get<double>(), result.next[0].at.x);
    EXPECT_EQ(natural["unit_lengths"][1][2].get<double>(), result.units.length[1][2]);

    const TemporaryFolder folder;
    write_table(folder / "residuals.csv", residuals_table(survey, validations[0]));
    const TextTable table = read_csv_table((folder / "residuals.csv").string());
    std::size_t residuals = 0;
    for (const auto* items : {&result.layers, &result.horizons})
        for (const ItemValidation& item : *items) residuals += item.residuals.size();
    EXPECT_EQ(table.row_count(), residuals + 1);
    EXPECT_EQ(residual_features(survey, validations[0]).size(), residuals);
    for (std::size_t r = 1; r < table.row_count(); ++r) {
        const auto number = [&](std::size_t column) { return std::stod(std::string(table.cell(r, column))); };
        EXPECT_NEAR(number(9), number(8) - number(7), 1e-9);
        EXPECT_LE(number(10), number(8));
        EXPECT_GE(number(11), number(8));
        EXPECT_TRUE(number(10) >= 0 || table.cell(r, 5) != "thickness");
    }
    EXPECT_EQ(errors_table(validations).rows.size(), 9u);
    EXPECT_EQ(unit_match_table(survey, validations[0]).columns.size(), 6u);
    EXPECT_EQ(next_boreholes_table(validations[0]).rows.size(), 5u);
}

TEST(Validation, drawings_are_whole_and_the_same_each_time) {
    const Survey survey = pinching_survey();
    const NamedValidation validation{"natural", validate(survey, fold_draws(60, 5, 1))};
    const TemporaryFolder folder;
    for (const char* name : {"map.png", "map.pdf"}) {  // cairo numbers the SVG pages of a process
        write_residual_map(folder / name, survey, validation);
        const std::string first = content_of(folder / name);
        EXPECT_GT(first.size(), 3000u);
        write_residual_map(folder / name, survey, validation);
        EXPECT_TRUE(content_of(folder / name) == first) << name;
    }
    write_residual_scatter(folder / "scatter.svg", survey, validation);
    const std::string svg = content_of(folder / "scatter.svg");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_THROW(write_residual_map(folder / "map.gif", survey, validation), IoError);
}

TEST(Validation, many_layers_and_none_known_are_drawn_too) {
    const Survey many = random_survey({.holes = 12, .layers = 40});
    const TemporaryFolder folder;
    const NamedValidation validation{"linear", validate(many, fold_draws(12, 4, 1))};
    write_residual_map(folder / "many.svg", many, validation);
    write_residual_scatter(folder / "many2.svg", many, validation);
    Survey none = random_survey({.holes = 8, .layers = 1});
    for (Borehole& hole : none.holes) {
        hole.layers[0] = {};
        hole.horizons[1].reset();
    }
    const NamedValidation unknown{"linear", validate(none, fold_draws(8, 4, 1))};
    EXPECT_EQ(unknown.result.layers[0].errors.count, 0u);
    EXPECT_EQ(unknown.result.pooled.units, 0u);
    write_residual_map(folder / "none.svg", none, unknown);
    EXPECT_NE(content_of(folder / "none.svg").find("</svg>"), std::string::npos);
    EXPECT_NO_THROW(validation_json(none, {unknown}, {}).dump());
}

// ---- volumes ----

TEST(LayerVolumes, are_those_of_the_solids) {
    for (const double spacing : {0.0, 20.0}) {
        const LayerModel model = build_layer_model(pinching_survey(), {.spacing = spacing});
        const auto volumes = layer_volumes(model);
        double sum = 0;
        for (std::size_t i = 0; i < model.units.size(); ++i) {
            EXPECT_NEAR(volumes[i], volume(build_layer_solid(model, i).surface),
                        1e-9 * envelope_volume(model));
            sum += volumes[i];
        }
        EXPECT_NEAR(sum, envelope_volume(model), 1e-9 * sum);
    }
}

TrueVolumes truth_of(const RandomSurveyOptions& options) {
    const AnalyticTruth truth = random_truth(options);
    const Point2 a = truth.corner, b{a.x + truth.extent, a.y + truth.extent};
    TrueVolumes volumes{.footprint = {{a, {b.x, a.y}, b, {a.x, b.y}}}};
    const Survey survey = random_survey(options);
    for (std::size_t i = 0; i < survey.units.size(); ++i) {
        volumes.codes.push_back(survey.units[i].code);
        volumes.volumes.push_back(truth.volume(i));
    }
    return volumes;
}

//! Mean over layers and seeds of the size of the volume's error, as a share.
double volume_error(std::size_t holes, TruthKind kind, bool pinch_outs) {
    double error = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const RandomSurveyOptions options{
            .holes = holes, .layers = 3, .seed = seed, .truth = kind, .pinch_outs = pinch_outs};
        const TrueVolumes truth = truth_of(options);
        const ComparedModel model = compare_volumes("", random_survey(options), truth, {.spacing = 10});
        for (std::size_t i = 0; i < 3; ++i)
            error += std::abs(model.volumes[i] - truth.volumes[i]) / truth.volumes[i] / 12;
    }
    return error;
}

//! 13, 52, 208 and 832 holes: four times as many each. Volumes come nearer to the truth every time.
TEST(LayerVolumes, converge_to_the_truth_with_more_holes) {
    for (const auto& [kind, pinch_outs, last] : {std::tuple{TruthKind::Random, false, 0.005},
                                                 {TruthKind::Random, true, 0.015},
                                                 {TruthKind::Dome, false, 0.001}}) {
        double before = 1;
        for (const std::size_t holes : {13u, 52u, 208u, 832u}) {
            const double error = volume_error(holes, kind, pinch_outs);
            EXPECT_LT(error, std::max(before, 2e-4)) << holes;
            before = error;
        }
        EXPECT_LT(before, last);
    }
}

//! The two examples of the thesis (its section 4.1.4.3), whose bodies it does not print, in its table's form: its percentages
//! come out of its volumes.
TEST(LayerVolumes, table_of_the_thesis) {
    const auto table = [](std::vector<double> actual, std::vector<double> few, std::vector<double> many) {
        TrueVolumes truth{.volumes = std::move(actual)};
        for (std::size_t i = 0; i < truth.volumes.size(); ++i) truth.codes.push_back(std::to_string(i + 1));
        return volumes_table(truth, {{"few", 13, std::move(few), 0}, {"many", 52, std::move(many), 0}});
    };
    const auto first =
        table({2990720, 1858561, 2990720}, {3201710, 1423441, 3215855}, {3146455, 1541584, 3151958});
    const auto second = table({5727577, 2112422}, {5696091, 2143909}, {5702192, 2137809});
    const auto cell = [](const OutputTable& t, std::size_t row, std::size_t column) {
        return std::get<double>(t.rows[row][column]);
    };
    const std::vector<std::vector<double>> printed{{7.055, 5.207}, {-23.412, -17.055}, {7.528, 5.391}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(cell(first, i, 3), printed[i][0], 6e-4);
        EXPECT_NEAR(cell(first, i, 5), printed[i][1], 6e-4);
    }
    EXPECT_NEAR(cell(second, 0, 3), -0.55, 6e-4);
    EXPECT_NEAR(cell(second, 1, 3), 1.491, 6e-4);
    EXPECT_NEAR(cell(second, 0, 5), -0.443, 6e-4);
    EXPECT_NEAR(cell(second, 1, 5), 1.202, 6e-4);
    EXPECT_EQ(cell(second, 2, 1), 7839999);
}

TEST(LayerVolumes, truth_files_are_checked) {
    const TemporaryFolder folder;
    const auto truth = read_true_volumes(
        folder.file("t.json", R"({"seed":1,"box":[0,0,10,20],"units":[{"order":1,"code":"a","volume":5}]})")
            .string());
    EXPECT_EQ(truth.footprint[0][2], (Point2{10, 20}));
    EXPECT_EQ(truth.codes[0], "a");
    const auto refused = [&](const char* text) {
        try {
            read_true_volumes(folder.file("bad.json", text).string());
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
        return std::string("read without complaint");
    };
    EXPECT_NE(refused(R"({"box":[0,0,0,20],"units":[]})").find("box"), std::string::npos);
    EXPECT_NE(refused(R"({"box":[0,0,1,1],"units":[{"code":"a"}]})").find("volume"), std::string::npos);
    EXPECT_NE(refused(R"([])").find("truth of a sample"), std::string::npos);
    EXPECT_NE(refused("{").find("bad.json"), std::string::npos);
    EXPECT_THROW(read_true_volumes((folder / "none.json").string()), IoError);
    const Survey survey = random_survey({.holes = 20, .layers = 2});
    TrueVolumes other = truth_of({.holes = 20, .layers = 2});
    other.codes[1] = "clay";
    EXPECT_THROW(compare_volumes("x", survey, other, {}), InvalidInput);
}

//! Geometric mean over layers of the RMSE as a share of linear interpolation's, thickness and base elevation, over some seeds.
double share_of_linear(const Survey& survey, InterpolatorKind kind, int seeds) {
    const std::size_t layers = survey.units.size();
    std::vector<double> squares(2 * layers), linear(2 * layers);
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto draws = fold_draws(survey.holes.size(), 10, static_cast<std::uint64_t>(seed));
        for (const bool is_linear : {false, true}) {
            HoldOutOptions options;
            options.prediction.interpolator = is_linear ? InterpolatorKind::Linear : kind;
            const auto held = hold_out(survey, draws, options);
            auto& sums = is_linear ? linear : squares;
            for (std::size_t i = 0; i < layers; ++i) {
                for (const Residual& r : thickness_residuals(survey, held, i))
                    sums[i] += r.error() * r.error();
                for (const Residual& r : elevation_residuals(survey, held, i + 1))
                    sums[layers + i] += r.error() * r.error();
            }
        }
    }
    double logs = 0;
    for (std::size_t q = 0; q < 2 * layers; ++q)
        logs += std::log(squares[q] / linear[q]) / 2 / static_cast<double>(2 * layers);
    return std::exp(logs);
}

TEST(Validation, the_default_predicts_smooth_and_noisy_layers_better_than_linear) {
    for (const double noise : {0.0, 3.0}) {
        Survey survey = random_survey({.holes = 150, .layers = 3, .seed = 5, .corners = false});
        std::mt19937_64 random(7);
        std::normal_distribution<double> error(0, noise);
        for (Borehole& hole : survey.holes)
            for (std::size_t i = 0; i < hole.layers.size(); ++i) {
                if (noise > 0)
                    hole.layers[i].thickness = std::max(0.5, hole.layers[i].thickness + error(random));
                hole.horizons[i + 1] = *hole.horizons[i] - hole.layers[i].thickness;
            }
        EXPECT_LT(share_of_linear(survey, kDefaultInterpolator, 1), noise > 0 ? 0.93 : 0.6) << noise;
    }
}

// ---- real data beside the source tree ----

struct SharedSet {
    const char* file;
    double most;  // of linear's errors that the default may have
};

double share_of(const Validation& one, const Validation& other) {
    std::vector<double> logs;
    const auto add = [&](const ItemValidation& a, const ItemValidation& b) {
        if (a.errors.count >= 30) logs.push_back(std::log(a.errors.rmse / b.errors.rmse));
    };
    for (std::size_t i = 0; i < one.layers.size(); ++i) {
        add(one.layers[i], other.layers[i]);
        add(one.horizons[i + 1], other.horizons[i + 1]);
    }
    return std::exp(std::accumulate(logs.begin(), logs.end(), 0.0) / static_cast<double>(logs.size()));
}

TEST(Validation, shared_sets_are_covered_uncrossed_and_better_than_by_linear_in_ten_folds) {
    const std::string data = STRATAREEB_SOURCE_DIR "/../shared/data/";
    if (!std::filesystem::exists(data + "baselines.csv")) GTEST_SKIP() << "no data beside the source tree";
    for (const SharedSet& set : {SharedSet{"teapot_dome/wide_shannon_noheader.csv", 0.9},
                                 SharedSet{"teapot_dome/wide_frontier_noheader.csv", 0.82},
                                 SharedSet{"louisiana_north/wide_claycap_noheader.csv", 0.88},
                                 SharedSet{"ags_uk/sighthill/wide_noheader.csv", 0.995},
                                 SharedSet{"ags_uk/wigan_depot/wide_noheader.csv", 0.93},
                                 SharedSet{"thesis/thesis_sample3_wide_noheader.csv", 0.91}}) {
        const Survey survey = read_boreholes({data + set.file}).survey;
        const auto draws = fold_draws(survey.holes.size(), 10, 1);
        std::vector<Validation> results;
        for (const InterpolatorKind kind : {InterpolatorKind::Linear, kDefaultInterpolator}) {
            ValidationOptions options;
            options.hold_out.prediction.interpolator = kind;
            const Validation& result = results.emplace_back(validate(survey, draws, options));
            EXPECT_GT(result.coverage, 0.93) << set.file;
            EXPECT_LT(result.coverage, 0.97) << set.file;
            EXPECT_EQ(result.crossings, 0u) << set.file;
            for (const auto* items : {&result.layers, &result.horizons})
                for (const ItemValidation& item : *items) {
                    if (item.errors.count < 100) continue;
                    EXPECT_GT(item.coverage(), 0.93) << set.file << ' ' << item.name;
                    EXPECT_LT(item.coverage(), 0.97) << set.file << ' ' << item.name;
                }
        }
        EXPECT_LT(share_of(results[1], results[0]), set.most) << set.file;
    }
}

}  // namespace
}  // namespace stratareeb
