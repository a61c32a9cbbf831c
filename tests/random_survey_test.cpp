// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/random_survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

//! Midpoint rule on an n × n raster: independent of the closed forms.
double volume_by_raster(const AnalyticTruth& truth, std::size_t layer, int n = 600) {
    const double step = truth.extent / n;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += truth.thickness(layer,
                                   {truth.corner.x + (i + 0.5) * step, truth.corner.y + (j + 0.5) * step});
    return sum * step * step;
}

constexpr TruthKind kTruths[] = {TruthKind::Slab, TruthKind::Dipping, TruthKind::Wedge,
                                 TruthKind::Dome, TruthKind::Lens,    TruthKind::Random};
constexpr HolePlan kPlans[] = {HolePlan::Random, HolePlan::Clustered, HolePlan::Grid, HolePlan::Line};

TEST(AnalyticTruth, closed_form_volumes_are_those_of_a_fine_raster) {
    for (const TruthKind kind : kTruths)
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const AnalyticTruth truth = random_truth({.layers = 4,
                                                      .seed = seed,
                                                      .corner = {5e6, 6e6},
                                                      .truth = kind,
                                                      .pinch_outs = seed % 2 == 0});
            for (std::size_t layer = 0; layer < 4; ++layer)
                EXPECT_NEAR(truth.volume(layer) / volume_by_raster(truth, layer), 1, 2e-4)
                    << "truth " << static_cast<int>(kind) << ", seed " << seed << ", layer " << layer;
        }
}

TEST(AnalyticTruth, simple_shapes_have_the_volumes_of_the_school_book) {
    const RandomSurveyOptions square{.layers = 2, .extent = 100, .thickness = 6};
    RandomSurveyOptions options = square;
    options.truth = TruthKind::Slab;
    EXPECT_DOUBLE_EQ(random_truth(options).volume(0), 100 * 100 * 6);
    options.truth = TruthKind::Wedge;
    EXPECT_DOUBLE_EQ(random_truth(options).volume(0), 100 * 100 * 12 / 2.0);
    EXPECT_DOUBLE_EQ(random_truth(options).thickness(0, {25, 50}), 3);
    EXPECT_DOUBLE_EQ(random_truth(options).thickness(1, {25, 50}), 9);
    options.truth = TruthKind::Lens;
    EXPECT_DOUBLE_EQ(random_truth(options).volume(1), std::numbers::pi * 40 * 40 * 6 / 3);
    EXPECT_EQ(random_truth(options).thickness(1, {5, 50}), 0);
    options.truth = TruthKind::Dome;
    EXPECT_DOUBLE_EQ(random_truth(options).ground({50, 50}) - random_truth(options).ground({0, 50}), 6);
}

TEST(AnalyticTruth, thickness_is_never_negative) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const AnalyticTruth truth = random_truth({.layers = 3, .seed = seed, .pinch_outs = seed % 2 == 0});
        for (double x = 0; x <= 300; x += 10)
            for (double y = 0; y <= 300; y += 10)
                for (std::size_t layer = 0; layer < 3; ++layer) EXPECT_GE(truth.thickness(layer, {x, y}), 0);
    }
}

TEST(RandomSurvey, holes_find_the_truth_to_the_resolution) {
    for (const HolePlan plan : kPlans)
        for (const TruthKind kind : kTruths) {
            RandomSurveyOptions options{
                .corner = {5e6, 6e6}, .plan = plan, .truth = kind, .pinch_outs = true};
            const AnalyticTruth truth = random_truth(options);
            for (const Borehole& hole : random_survey(options).holes) {
                ASSERT_EQ(hole.layers.size(), 3u);
                ASSERT_EQ(hole.horizons.size(), 4u);
                EXPECT_NEAR(*hole.horizons[0], truth.ground(hole.at), 0.00051);
                for (std::size_t i = 0; i < 3; ++i) {
                    EXPECT_EQ(hole.layers[i].knowledge, Knowledge::Measured);
                    EXPECT_NEAR(hole.layers[i].thickness, truth.thickness(i, hole.at), 0.00051);
                    EXPECT_DOUBLE_EQ(*hole.horizons[i] - hole.layers[i].thickness, *hole.horizons[i + 1]);
                }
            }
        }
}

TEST(RandomSurvey, no_two_holes_share_a_place_and_all_lie_in_the_square) {
    for (const HolePlan plan : kPlans)
        for (const std::size_t count : {3, 4, 5, 52, 2000}) {
            const Survey survey =
                random_survey({.holes = count, .extent = 50, .corner = {-20, 10}, .plan = plan});
            std::set<std::pair<double, double>> places;
            for (const Borehole& hole : survey.holes) {
                places.insert({hole.at.x, hole.at.y});
                EXPECT_TRUE(hole.at.x >= -20 && hole.at.x <= 30 && hole.at.y >= 10 && hole.at.y <= 60);
            }
            EXPECT_EQ(places.size(), count);
        }
}

TEST(RandomSurvey, four_holes_stand_in_the_corners_on_demand) {
    for (const bool corners : {true, false}) {
        std::size_t found = 0;
        for (const Borehole& hole : random_survey({.holes = 20, .corners = corners}).holes)
            found += (hole.at.x == 0 || hole.at.x == 300) && (hole.at.y == 0 || hole.at.y == 300);
        EXPECT_EQ(found, corners ? 4u : 0u);
    }
}

TEST(RandomSurvey, one_seed_gives_one_survey_everywhere) {
    // Written down once; a library or compiler that draws other numbers shows here.
    const Survey survey = random_survey({.corners = false});
    ASSERT_EQ(survey.holes.size(), 52u);
    EXPECT_EQ(survey.holes[0].at, (Point2{11.521, 200.512}));
    const Survey again = random_survey({.corners = false}),
                 other = random_survey({.seed = 2, .corners = false});
    for (std::size_t i = 0; i < 52; ++i) {
        EXPECT_EQ(again.holes[i].at, survey.holes[i].at);
        EXPECT_NE(other.holes[i].at, survey.holes[i].at);
    }
}

TEST(RandomSurvey, more_holes_are_drilled_into_the_same_truth) {
    const AnalyticTruth few = random_truth({.holes = 10, .seed = 7}),
                        many = random_truth({.holes = 900, .seed = 7});
    EXPECT_EQ(few.ground({12, 34}), many.ground({12, 34}));
    EXPECT_EQ(few.thickness(1, {12, 34}), many.thickness(1, {12, 34}));
}

TEST(RandomSurvey, losses_come_in_the_shares_asked_for) {
    const Survey survey = random_survey(
        {.holes = 4000, .layers = 4, .zero_share = 0.2, .unknown_share = 0.1, .cut_off_share = 0.3});
    double absent = 0, unknown_tops = 0, cut_off = 0;
    for (const Borehole& hole : survey.holes) {
        absent += hole.layers[0].is_absent();
        unknown_tops += hole.layers[0].knowledge == Knowledge::Unknown;
        bool ended = false;
        for (std::size_t i = 0; i < 4; ++i) {
            const LayerFact& fact = hole.layers[i];
            EXPECT_TRUE(!ended || fact.knowledge == Knowledge::Unknown) << "known below the end of a hole";
            if (fact.knowledge == Knowledge::AtLeast) {
                EXPECT_GT(fact.thickness, 0);
                ended = true;
            }
            EXPECT_TRUE(fact.knowledge == Knowledge::Measured || !hole.horizons[i + 1].has_value());
        }
        cut_off += ended;
    }
    EXPECT_NEAR(absent / 4000, 0.2 * 0.9, 0.03);
    EXPECT_NEAR(unknown_tops / 4000, 0.1, 0.02);
    EXPECT_NEAR(cut_off / 4000, 0.3 * 0.8 * 0.9, 0.03);  // a hole can't end inside a layer that it lacks
}

TEST(RandomSurvey, line_is_nearly_but_not_exactly_collinear) {
    const Survey survey = random_survey({.plan = HolePlan::Line});
    double largest = 0;
    for (const Borehole& hole : survey.holes) largest = std::max(largest, std::abs(hole.at.x - hole.at.y));
    EXPECT_GT(largest, 0);
    EXPECT_LE(largest, 0.3 + 1e-9);
}

TEST(RandomSurvey, hundred_thousand_holes_and_thin_layers_are_fine) {
    EXPECT_EQ(random_survey({.holes = 100000}).holes.size(), 100000u);
    const Survey thin = random_survey({.corner = {5e6, 5e6}, .thickness = 1e-6, .resolution = 0});
    for (const Borehole& hole : thin.holes) {
        EXPECT_GT(hole.layers[0].thickness, 0);
        EXPECT_LT(hole.layers[0].thickness, 2e-6);
    }
}

TEST(RandomSurvey, senseless_options_are_refused) {
    EXPECT_THROW(random_survey({.holes = 2}), InvalidInput);
    EXPECT_THROW(random_survey({.layers = 0}), InvalidInput);
    EXPECT_THROW(random_survey({.extent = 0}), InvalidInput);
    EXPECT_THROW(random_survey({.extent = NAN}), InvalidInput);
    EXPECT_THROW(random_survey({.thickness = -1}), InvalidInput);
    EXPECT_THROW(random_survey({.resolution = -1}), InvalidInput);
    EXPECT_THROW(random_survey({.zero_share = 1.5}), InvalidInput);
    EXPECT_THROW(random_survey({.holes = 200, .extent = 1, .resolution = 0.1}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
