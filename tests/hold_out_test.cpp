// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hold_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "boreholes/error_statistics.h"
#include "boreholes/errors.h"
#include "boreholes/linear_tin.h"
#include "boreholes/permutation.h"
#include "boreholes/predict_columns.h"
#include "boreholes/random_survey.h"
#include "boreholes/unit_match.h"
#include "tests/thesis_rows.h"

namespace stratareeb {
namespace {

//! As the thesis predicts: linear on the bare triangulation, thickness 0 as a value like any other.
HoldOutOptions as_the_thesis() {
    HoldOutOptions options;
    options.prediction.interpolator = InterpolatorKind::Linear;
    options.prediction.pinch_out.fraction = 0;
    options.bare = true;
    return options;
}

Borehole measured(const std::string& id, Point2 at, const std::vector<double>& thickness, double ground = 0) {
    Borehole hole{.id = id, .at = at};
    hole.horizons.push_back(ground);
    for (const double t : thickness) {
        hole.layers.push_back({Knowledge::Measured, t});
        hole.horizons.push_back(*hole.horizons.back() - t);
    }
    return hole;
}

Survey survey_of(std::vector<Borehole> holes) {
    Survey survey;
    for (std::size_t i = 0; i < holes.front().layers.size(); ++i)
        survey.units.push_back({std::to_string(i + 1), "", ""});
    survey.holes = std::move(holes);
    return survey;
}

// ---- draws ----

TEST(HoldOutDraws, permutation_is_that_of_numpy) {
    // numpy 1.24: default_rng(seed).permutation(n)
    EXPECT_EQ(random_permutation(10, 1), (std::vector<std::size_t>{8, 4, 7, 0, 1, 2, 5, 9, 6, 3}));
    EXPECT_EQ(random_permutation(12, 0), (std::vector<std::size_t>{9, 2, 7, 4, 5, 11, 0, 3, 6, 10, 8, 1}));
    EXPECT_EQ(random_permutation(12, (std::uint64_t{1} << 40) + 7),
              (std::vector<std::size_t>{8, 2, 6, 1, 11, 9, 3, 7, 4, 5, 0, 10}));
    EXPECT_EQ(random_permutation(1, 1), std::vector<std::size_t>{0});
    EXPECT_TRUE(random_permutation(0, 1).empty());
    const auto thousand = random_permutation(1000, 1);
    EXPECT_EQ((std::vector<std::size_t>(thousand.begin(), thousand.begin() + 8)),
              (std::vector<std::size_t>{705, 649, 543, 927, 577, 471, 608, 252}));
}

TEST(HoldOutDraws, permutations_are_fair) {
    std::vector<int> first(5, 0);
    for (std::uint64_t seed = 0; seed < 10'000; ++seed) {
        auto order = random_permutation(5, seed);
        ++first[order[0]];
        std::ranges::sort(order);
        ASSERT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    }
    for (const int count : first) EXPECT_NEAR(count, 2000, 160);  // four standard deviations
}

TEST(HoldOutDraws, folds_leave_every_hole_out_once) {
    for (const std::size_t holes : {2u, 7u, 20u, 101u})
        for (const std::size_t folds : {std::size_t{2}, holes / 2 + 1, holes}) {
            const auto draws = fold_draws(holes, folds, 3);
            ASSERT_EQ(draws.size(), folds);
            std::vector<std::size_t> all;
            for (const Draw& draw : draws) {
                EXPECT_TRUE(std::ranges::is_sorted(draw));
                EXPECT_GE(draw.size(), holes / folds);
                EXPECT_LE(draw.size(), holes / folds + 1);
                all.insert(all.end(), draw.begin(), draw.end());
            }
            std::ranges::sort(all);
            std::vector<std::size_t> expected(holes);
            std::iota(expected.begin(), expected.end(), std::size_t{0});
            EXPECT_EQ(all, expected);
        }
    EXPECT_THROW(fold_draws(5, 1, 1), InvalidInput);
    EXPECT_THROW(fold_draws(5, 6, 1), InvalidInput);
}

TEST(HoldOutDraws, the_thesis_way_goes_on_until_the_share_has_been_out) {
    for (const auto& [holes, at_a_time, draws] :
         {std::tuple{52u, 2u, 8u}, {104u, 5u, 7u}, {203u, 10u, 7u}, {10u, 3u, 1u}}) {
        const auto made = repeated_draws(holes, at_a_time, 0.3, 1);
        EXPECT_EQ(made.size(), draws) << holes;
        std::set<std::size_t> out;
        for (const Draw& draw : made) {
            EXPECT_EQ(draw.size(), at_a_time);
            out.insert(draw.begin(), draw.end());
        }
        EXPECT_EQ(out.size(), draws * at_a_time);  // none twice
        EXPECT_GE(static_cast<double>(out.size()), 0.3 * holes);
    }
    EXPECT_EQ(repeated_draws(10, 3, 1, 1).back().size(), 1u);  // the last takes what is left
    EXPECT_NE(repeated_draws(50, 5, 0.3, 1), repeated_draws(50, 5, 0.3, 2));
    EXPECT_THROW(repeated_draws(5, 5, 0.3, 1), InvalidInput);
    EXPECT_THROW(repeated_draws(5, 0, 0.3, 1), InvalidInput);
    EXPECT_THROW(repeated_draws(5, 1, 0, 1), InvalidInput);
    EXPECT_THROW(repeated_draws(5, 1, std::nan(""), 1), InvalidInput);
}

// ---- what the thesis printed ----

//! All holes of a sample whose thicknesses are known: those of its table; samples 1 and 2 are the same holes, the
//! second with a copy moved by 120 in x (tests/thesis/README.md).
std::map<std::pair<double, double>, std::vector<double>> known_holes(int sample) {
    std::map<std::pair<double, double>, std::vector<double>> holes;
    for (const auto& row : thesis::rows_of(sample == 3 ? 3 : 1)) holes[{row.at.x, row.at.y}] = row.actual;
    if (sample == 3) return holes;
    std::map<std::pair<double, double>, std::vector<double>> second;
    for (const auto& row : thesis::rows_of(2)) second[{row.at.x, row.at.y}] = row.actual;
    auto first = holes;
    for (const auto& [at, thickness] : second) {
        const auto is = [&](const auto& set, double x) {
            const auto found = set.find({x, at.second});
            return found != set.end() && found->second == thickness;
        };
        if (!holes.contains(at) && !is(holes, at.first - 120) && is(second, at.first + 120))
            first[at] = thickness;
    }
    if (sample == 1) return first;
    auto all = first;
    for (const auto& [at, thickness] : second) all[at] = thickness;
    for (const auto& [at, thickness] : first) all.try_emplace({at.first + 120, at.second}, thickness);
    return all;
}

//! Rows of Tables 4.2 to 4.4 whose neighbours are all printed, so that their estimates can be made again.
const std::vector<std::vector<std::size_t>> kReproducible{
    {2, 3, 4, 5, 6, 10, 13, 17, 18}, {1, 3, 4, 6, 8, 10, 19, 25, 27, 29}, {9, 36}};

TEST(HoldOut, golden_estimates_of_the_thesis_come_out_to_the_printed_digits) {
    std::size_t reproduced = 0;
    for (int sample = 1; sample <= 3; ++sample) {
        const auto known = known_holes(sample);
        std::vector<Borehole> holes;
        std::map<std::pair<double, double>, std::size_t> number;
        for (const auto& [at, thickness] : known) {
            number[at] = holes.size();
            holes.push_back(measured("", {at.first, at.second}, thickness));
        }
        const Survey survey = survey_of(std::move(holes));
        const auto rows = thesis::rows_of(sample);
        std::vector<Draw> draws(rows.back().draw);
        for (const auto& row : rows) draws[row.draw - 1].push_back(number.at({row.at.x, row.at.y}));
        const auto held = hold_out(survey, draws, as_the_thesis());
        const double last_digit = sample == 3 ? 1.1e-3 : 8e-5;
        for (const std::size_t golden : kReproducible[static_cast<std::size_t>(sample) - 1]) {
            const auto& row = rows[golden - 1];
            const auto found = std::ranges::find_if(held, [&](const HeldOutHole& hole) {
                return hole.draw + 1 == row.draw && hole.hole == number.at({row.at.x, row.at.y});
            });
            ASSERT_NE(found, held.end());
            for (std::size_t i = 0; i < row.estimated.size(); ++i)
                EXPECT_NEAR(found->thickness[i], row.estimated[i], last_digit)
                    << "sample " << sample << " row " << golden << " layer " << i + 1;
            ++reproduced;
        }
    }
    EXPECT_EQ(reproduced, 21u);
}

//! The shipped 56 holes of sample 3, ten folds: figures of SciPy's Delaunay interpolation of the same folds.
TEST(HoldOut, ten_folds_agree_with_another_program) {
    std::vector<Borehole> holes;
    std::set<std::pair<double, double>> seen;
    const TextTable table = read_csv_table(STRATAREEB_SOURCE_DIR "/examples/thesis_sample3.csv");
    for (std::size_t r = 0; r < table.row_count(); ++r) {
        std::vector<double> thickness;
        for (std::size_t column = 4; column < table.cell_count(r); column += 2)
            thickness.push_back(thesis::number(table, r, column));
        holes.push_back(measured("", {thesis::number(table, r, 0), thesis::number(table, r, 1)}, thickness));
    }
    ASSERT_EQ(holes.size(), 56u);
    const Survey survey = survey_of(std::move(holes));
    const auto held = hold_out(survey, fold_draws(56, 10, 1), as_the_thesis());
    const std::vector<double> rmse{11.238, 13.3985, 5.3933, 10.4287, 4.3215, 14.6279, 15.7471};
    const std::vector<double> median{9.6815, 11.5309, 0, 7.7624, 0, 13.2609, 12.022};
    for (std::size_t layer = 0; layer < 7; ++layer) {
        std::vector<double> inside;
        for (const Residual& residual : thickness_residuals(survey, held, layer))
            if (residual.inside) inside.push_back(residual.error());
        const ErrorSummary errors = summarize_errors(inside);
        EXPECT_EQ(errors.count, 46u);
        EXPECT_NEAR(errors.rmse, rmse[layer], 5.1e-5);
        EXPECT_NEAR(errors.median_size, median[layer], 5.1e-5);
    }
}

// ---- properties ----

TEST(HoldOut, a_plane_is_predicted_without_error) {
    std::vector<Borehole> holes;
    for (int i = 0; i < 60; ++i) {
        const Point2 at{std::fmod(i * 37.7, 100), std::fmod(i * 61.3, 100)};
        holes.push_back(measured("", at, {5 + 0.02 * at.x, 9 - 0.01 * at.y}, 100 + 0.1 * at.x - 0.05 * at.y));
    }
    const Survey survey = survey_of(std::move(holes));
    for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
        HoldOutOptions options;
        options.prediction.interpolator = kind;
        options.bare = true;
        for (const HeldOutHole& hole : hold_out(survey, single_draws(60), options)) {
            if (!hole.inside) continue;
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(hole.horizons[k], *survey.holes[hole.hole].horizons[k], 1e-9);
        }
    }
}

TEST(HoldOut, a_hole_left_out_has_no_say_and_nor_has_its_draw) {
    const Survey survey = random_survey({.holes = 40, .layers = 3, .pinch_outs = true});
    const auto draws = fold_draws(40, 8, 5);
    const auto held = hold_out(survey, draws);
    Survey changed = survey;
    for (const std::size_t h : draws[2])
        changed.holes[h] = measured("", survey.holes[h].at, {99, 0, 77}, 1234);
    const auto again = hold_out(changed, draws);
    bool others_changed = false;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const bool same = held[i].horizons == again[i].horizons;
        EXPECT_TRUE(same || held[i].draw != 2);
        others_changed = others_changed || !same;
    }
    EXPECT_TRUE(others_changed);
    // and predictions are those of a survey without them
    Survey rest = survey;
    rest.holes.clear();
    for (std::size_t h = 0; h < 40; ++h)
        if (!std::ranges::binary_search(draws[2], h)) rest.holes.push_back(survey.holes[h]);
    const ColumnPredictor predictor(rest);
    for (const HeldOutHole& hole : held) {
        if (hole.draw != 2) continue;
        const auto columns = predictor.at(std::vector<Point2>{survey.holes[hole.hole].at});
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(columns.horizon(k, 0), hole.horizons[k], 1e-9);
    }
}

TEST(HoldOut, far_coordinates_change_nothing) {
    const RandomSurveyOptions near{.holes = 50, .pinch_outs = true};
    RandomSurveyOptions far = near;
    far.corner = {5'000'000, 4'000'000};
    const auto draws = fold_draws(50, 5, 1);
    const Survey first = random_survey(near), second = random_survey(far);
    // Kriging fits its variogram, and rounding of coordinates may lead the fit a little astray.
    for (const auto& [kind, tolerance] :
         {std::pair(InterpolatorKind::NaturalNeighbour, 2e-5), std::pair(InterpolatorKind::Linear, 2e-5),
          std::pair(InterpolatorKind::Kriging, 0.3)}) {
        HoldOutOptions options;
        options.prediction.interpolator = kind;
        const auto a = hold_out(first, draws, options), b = hold_out(second, draws, options);
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(a[i].horizons[k], b[i].horizons[k], tolerance) << name_of(kind);
    }
}

TEST(HoldOut, no_horizons_cross_in_hostile_surveys) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const Survey survey = random_survey({.holes = 60,
                                             .layers = 5,
                                             .seed = seed,
                                             .plan = seed % 3 == 0 ? HolePlan::Clustered : HolePlan::Random,
                                             .pinch_outs = true,
                                             .zero_share = 0.2,
                                             .unknown_share = 0.2,
                                             .cut_off_share = 0.3});
        for (const InterpolatorKind kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
            HoldOutOptions options;
            options.prediction.interpolator = kind;
            const auto held = hold_out(survey, fold_draws(60, 10, seed), options);
            EXPECT_EQ(held.size(), 60u);
            EXPECT_EQ(count_crossings(held), 0u);
            for (const HeldOutHole& hole : held)
                for (const double z : hole.horizons) EXPECT_TRUE(std::isfinite(z));
        }
    }
}

TEST(HoldOut, crossings_are_counted) {
    EXPECT_EQ(
        count_crossings(std::vector<HeldOutHole>{{.horizons = {3, 2, 2, 1}}, {.horizons = {3, 4, 1, 2}}}),
        2u);
}

TEST(HoldOut, the_same_whatever_the_order_of_threads) {
    const Survey survey = random_survey({.holes = 300, .layers = 4, .pinch_outs = true});
    const auto draws = fold_draws(300, 20, 1);
    double last = 0;
    HoldOutOptions options;
    options.progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    const auto first = hold_out(survey, draws, options);
    EXPECT_EQ(last, 1);
    for (int run = 0; run < 3; ++run) {
        const auto again = hold_out(survey, draws);
        ASSERT_EQ(again.size(), first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            EXPECT_EQ(again[i].hole, first[i].hole);
            EXPECT_EQ(again[i].horizons, first[i].horizons);
        }
    }
}

TEST(HoldOut, residuals_are_of_what_is_known) {
    Survey survey = survey_of({measured("a", {0, 0}, {1, 2}), measured("b", {10, 0}, {1, 2}),
                               measured("c", {0, 10}, {1, 2}), measured("d", {10, 10}, {1, 2}),
                               measured("e", {4, 5}, {1, 2})});
    survey.holes[4].layers[1] = {Knowledge::AtLeast, 2.5};
    survey.holes[4].horizons[2].reset();
    survey.holes[3].layers[1] = {Knowledge::Unknown, 0};
    survey.holes[3].horizons[2].reset();
    const auto held = hold_out(survey, single_draws(5), as_the_thesis());
    EXPECT_EQ(thickness_residuals(survey, held, 0).size(), 5u);
    EXPECT_EQ(thickness_residuals(survey, held, 1).size(), 3u);
    EXPECT_EQ(elevation_residuals(survey, held, 0).size(), 5u);
    EXPECT_EQ(elevation_residuals(survey, held, 2).size(), 3u);
    const BoundCheck bounds = check_bounds(survey, held, 1);
    EXPECT_EQ(bounds.bounds, 1u);
    EXPECT_EQ(bounds.below, 1u);
    EXPECT_NEAR(bounds.shortfall, 0.5, 1e-12);
    EXPECT_EQ(check_bounds(survey, held, 0).bounds, 0u);
    EXPECT_TRUE(held[4].inside);
    EXPECT_FALSE(held[0].inside);
}

TEST(HoldOut, contacts_of_single_horizons_are_predicted_too) {
    Survey survey = survey_of({measured("a", {0, 0}, {1}), measured("b", {100, 0}, {1})});
    survey.holes.clear();
    survey.contact_points = true;
    for (int i = 0; i < 50; ++i) {
        Borehole hole{.at = {std::fmod(i * 37.7, 100), std::fmod(i * 61.3, 100)}};
        hole.layers.resize(1);
        hole.horizons.resize(2);
        hole.horizons[static_cast<std::size_t>(i) % 2] = (i % 2 ? 10 : 30) + 0.1 * hole.at.x;
        survey.holes.push_back(hole);
    }
    HoldOutOptions options = as_the_thesis();
    const auto held = hold_out(survey, single_draws(50), options);
    std::size_t checked = 0;
    for (std::size_t k = 0; k < 2; ++k)
        for (const Residual& residual : elevation_residuals(survey, held, k))
            if (residual.inside) checked += std::abs(residual.error()) < 1.0;
    EXPECT_GT(checked, 30u);
    EXPECT_TRUE(thickness_residuals(survey, held, 0).empty());
}

TEST(HoldOut, the_last_contact_of_a_horizon_stays) {
    Survey survey = survey_of({measured("a", {0, 0}, {1})});
    survey.holes.clear();
    survey.contact_points = true;
    for (int i = 0; i < 6; ++i) {
        Borehole hole{.at = {1.0 * i, 1.0 * i * i}};
        hole.layers.resize(1);
        hole.horizons.resize(2);
        hole.horizons[i < 2 ? 1 : 0] = 5.0 - i;
        survey.holes.push_back(hole);
    }
    // Holes 0 and 1 alone know the base: one of them stays in whenever both would go.
    const std::vector<Draw> draws{{0, 1, 2}, {3}, {0}, {2, 3, 4, 5}};
    const std::vector<Draw> expected{{0, 2}, {3}, {0}, {2, 3, 4}};
    EXPECT_EQ(without_last_contacts(survey, draws), expected);
    EXPECT_EQ(hold_out(survey, without_last_contacts(survey, draws), as_the_thesis()).size(), 7u);
    survey.holes.erase(survey.holes.begin());
    EXPECT_EQ(without_last_contacts(survey, {{0}, {1}}), (std::vector<Draw>{{1}}));
    survey.contact_points = false;
    EXPECT_EQ(without_last_contacts(survey, draws), draws);
}

// Two blocks beside each other with a throw of 30 between them: errors of one never tell of the other.
TEST(HoldOut, never_looks_across_a_fault) {
    Survey west = random_survey({.holes = 40, .layers = 2, .seed = 3, .corners = false}), both = west;
    Survey east = random_survey({.holes = 40, .layers = 2, .seed = 4, .corners = false});
    HoldOutOptions options;
    options.block.assign(40, 7);
    for (Borehole& hole : east.holes) {
        for (auto& z : hole.horizons) z = *z - 30;
        hole.layers[0].thickness += 5;
        for (std::size_t k = 1; k < hole.horizons.size(); ++k) hole.horizons[k] = *hole.horizons[k] - 5;
        both.holes.push_back(hole);
        options.block.push_back(2);
    }
    std::vector<Draw> draws;
    for (const Draw& draw : fold_draws(40, 5, 1)) {
        draws.push_back(draw);
        for (const std::size_t h : draw) draws.back().push_back(40 + h);
    }
    const auto held = hold_out(both, draws, options);
    const auto of_west = hold_out(west, fold_draws(40, 5, 1)), of_east = hold_out(east, fold_draws(40, 5, 1));
    ASSERT_EQ(held.size(), 80u);
    for (const HeldOutHole& hole : held) {
        const auto& alone = hole.hole < 40 ? of_west : of_east;
        const auto same =
            std::ranges::find(alone, hole.hole < 40 ? hole.hole : hole.hole - 40, &HeldOutHole::hole);
        EXPECT_EQ(hole.horizons, same->horizons);
        EXPECT_EQ(hole.draw, same->draw);
    }
}

TEST(HoldOut, the_last_hole_of_a_block_stays) {
    const std::vector<std::uint32_t> block{1, 1, 0, 2, 2, 2};
    EXPECT_EQ(without_whole_blocks(block, {{0, 1, 3}, {2}, {3, 4, 5}, {0, 4}}),
              (std::vector<Draw>{{1, 3}, {4, 5}, {0, 4}}));
    EXPECT_EQ(without_whole_blocks({}, {{0, 1}}), (std::vector<Draw>{{0, 1}}));
}

TEST(HoldOut, too_few_left_is_said_with_the_draw) {
    Survey survey = survey_of({measured("a", {0, 0}, {1}), measured("b", {10, 0}, {1})});
    EXPECT_EQ(hold_out(survey, single_draws(2), as_the_thesis()).size(), 2u);
    try {
        hold_out(survey, {{0}, {0, 1}}, as_the_thesis());
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("draw 2 of 2"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("leave out fewer"), std::string::npos);
    }
}

TEST(UnitMatch, lengths_by_hand) {
    Survey survey = survey_of({measured("a", {0, 0}, {2, 3, 5})});
    const std::vector<HeldOutHole> held{{.hole = 0, .thickness = {1, 4, 2}}};
    // drilled 0-2, 2-5, 5-10; predicted 0-1, 1-5, 5-7, then below the model
    const UnitMatch match = match_units(survey, held);
    EXPECT_EQ(match.length[0], (std::vector<double>{1, 1, 0, 0}));
    EXPECT_EQ(match.length[1], (std::vector<double>{0, 3, 0, 0}));
    EXPECT_EQ(match.length[2], (std::vector<double>{0, 0, 2, 3}));
    EXPECT_DOUBLE_EQ(match.share_right(), 0.6);
    EXPECT_DOUBLE_EQ(match.drilled(2), 5);
    survey.holes[0].layers[1] = {Knowledge::AtLeast, 1};  // ended at 3
    survey.holes[0].layers[2] = {};
    EXPECT_DOUBLE_EQ(match_units(survey, held).share_right(), 2.0 / 3);
    survey.holes[0].layers[0] = {};
    EXPECT_EQ(match_units(survey, held).share_right(), 0);
}

//! The share of length is what ever more samples down the hole tend to.
TEST(UnitMatch, share_of_length_is_the_limit_of_samples) {
    const Survey survey = random_survey({.holes = 40, .layers = 4, .pinch_outs = true});
    const auto held = hold_out(survey, fold_draws(40, 5, 1));
    std::size_t right = 0, samples = 0;
    const auto unit_at = [](const auto& thickness, double depth) {
        std::size_t unit = 0;
        for (double base = 0; unit < thickness.size() && (base += thickness[unit]) <= depth;) ++unit;
        return unit;
    };
    for (const HeldOutHole& hole : held) {
        std::vector<double> drilled;
        for (const LayerFact& fact : survey.holes[hole.hole].layers) drilled.push_back(fact.thickness);
        const double depth = std::accumulate(drilled.begin(), drilled.end(), 0.0);
        for (double d = 0.0005; d < depth; d += 0.001) {
            ++samples;
            right += unit_at(drilled, d) == unit_at(hole.thickness, d);
        }
    }
    EXPECT_NEAR(match_units(survey, held).share_right(),
                static_cast<double>(right) / static_cast<double>(samples), 1e-3);
}

// ---- real data beside the source tree ----

struct WideRow {
    Point2 at;
    double ground;
    std::vector<double> thickness;
};

std::vector<WideRow> wide_rows(const std::string& file) {
    std::vector<WideRow> rows;
    const TextTable table = read_csv_table(file);
    for (std::size_t r = 0; r < table.row_count(); ++r) {
        WideRow& row = rows.emplace_back();
        row.at = {thesis::number(table, r, 0), thesis::number(table, r, 1)};
        row.ground = thesis::number(table, r, 2);
        for (std::size_t column = 4; column < table.cell_count(r); column += 2)
            if (!table.cell(r, column).empty()) row.thickness.push_back(thesis::number(table, r, column));
    }
    return rows;
}

//! Ten-fold errors of one layer alone inside the hull, with folds over the rows of the file. Of holes at one place the first has
//! a say; a hole that is left out sees its twin.
std::vector<double> baseline_errors(const std::vector<WideRow>& rows, const std::vector<char>& use,
                                    const std::vector<double>& value) {
    const auto order = random_permutation(rows.size(), 1);
    std::vector<double> errors;
    for (std::size_t fold = 0; fold < 10; ++fold) {
        std::vector<Borehole> rest;
        std::set<std::pair<double, double>> places;
        std::vector<Point2> where;
        std::vector<double> actual;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (!use[r]) continue;
            if (order[r] % 10 == fold) {
                where.push_back(rows[r].at);
                actual.push_back(value[r]);
            } else if (places.insert({rows[r].at.x, rows[r].at.y}).second) {
                rest.push_back(measured("", rows[r].at, {1}, value[r]));
            }
        }
        const HoldOutOptions options = as_the_thesis();
        const auto predicted =
            ColumnPredictor(survey_of(std::move(rest)), options.prediction, true).at(where);
        for (std::size_t i = 0; i < where.size(); ++i)
            if (predicted.inside[i]) errors.push_back(predicted.ground[i] - actual[i]);
    }
    return errors;
}

//! baselines.csv knows a layer at holes that drilled through it; a last thickness that the end of the hole cut off is not known.
TEST(HoldOut, baselines_of_the_shared_sets_come_out) {
    const std::string data = STRATAREEB_SOURCE_DIR "/../shared/data/";
    if (!std::filesystem::exists(data + "baselines.csv")) GTEST_SKIP() << "no data beside the source tree";
    const TextTable baselines = read_csv_table(data + "baselines.csv");
    std::size_t exact = 0;
    for (std::size_t b = 1; b < baselines.row_count(); ++b) {
        const std::string file(baselines.cell(b, 0));
        const auto layer = static_cast<std::size_t>(thesis::number(baselines, b, 1)) - 1;
        const bool cut_off = !file.starts_with("teapot") && !file.starts_with("thesis");
        const auto rows = wide_rows(data + file);
        std::vector<char> use;
        std::vector<double> value;
        for (const WideRow& row : rows) {
            use.push_back(row.thickness.size() > layer + cut_off);
            value.push_back(0);
            if (!use.back()) continue;
            value.back() = row.thickness[layer];
            if (baselines.cell(b, 2) == "thickness") continue;
            value.back() = row.ground;
            for (std::size_t i = 0; i <= layer; ++i) value.back() -= row.thickness[i];
        }
        const double expected = thesis::number(baselines, b, 5);
        const ErrorSummary errors = summarize_errors(baseline_errors(rows, use, value));
        exact += std::abs(errors.rmse - expected) < 5.1e-5;
        // Which of the holes at one place the baseline took is not known.
        EXPECT_NEAR(errors.rmse, expected, 0.02 * expected) << file << ' ' << layer + 1;
    }
    EXPECT_GE(exact, 39u);
}

}  // namespace
}  // namespace stratareeb
