// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_model.h"

#include <gtest/gtest.h>

#include <random>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "tests/model_soundness.h"

namespace stratareeb {
namespace {

using testing::expect_sound;

struct Case {
    RandomSurveyOptions survey;
    LayerModelOptions model;
};

//! A random survey and random options from one number.
Case random_case(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    const auto share = [&](double most) { return most * static_cast<double>(below(1000)) / 1000; };
    Case c;
    c.survey.seed = seed;
    c.survey.holes = 3 + below(58);
    c.survey.layers = 1 + below(6);
    c.survey.plan =
        std::array{HolePlan::Random, HolePlan::Clustered, HolePlan::Grid, HolePlan::Line}[below(4)];
    c.survey.truth = std::array{TruthKind::Random, TruthKind::Lens, TruthKind::Wedge, TruthKind::Dipping,
                                TruthKind::Dome}[below(5)];
    c.survey.pinch_outs = below(2);
    c.survey.corners = below(2);
    c.survey.zero_share = below(2) ? share(0.6) : 0;
    c.survey.unknown_share = below(2) ? share(0.4) : 0;
    c.survey.cut_off_share = below(2) ? share(0.5) : 0;
    if (below(4) == 0) c.survey.thickness = 0.05;
    if (below(2)) c.survey.corner = {5e6, 4.9e6};
    c.model.interpolator = below(2) ? InterpolatorKind::Linear : InterpolatorKind::NaturalNeighbour;
    c.model.pinch_out.fraction = std::array{0.0, 0.25, 1.0 / 3, 0.5}[below(4)];
    if (below(3) == 0) c.model.spacing = 0;
    return c;
}

class RandomModels : public ::testing::TestWithParam<int> {};

TEST_P(RandomModels, are_watertight_conforming_and_true_to_their_holes) {
    constexpr int kSeedsPerTest = 50;
    int refused = 0;  // surveys too close to a line for a hull
    for (int k = 0; k < kSeedsPerTest; ++k) {
        const auto seed =
            static_cast<std::uint64_t>(GetParam()) * kSeedsPerTest + static_cast<std::uint64_t>(k) + 1;
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Case c = random_case(seed);
        const Survey survey = random_survey(c.survey);
        LayerModelOptions options = c.model;
        // The suitable spacing now and then: more triangles of the same kinds prove little.
        if (!options.spacing && seed % 20) options.spacing = c.survey.extent / (seed % 4 ? 8 : 12);
        try {
            expect_sound(build_layer_model(survey, options), survey);
        } catch (const InvalidInput& error) {
            ASSERT_EQ(c.survey.plan, HolePlan::Line) << error.what();
            ASSERT_NE(std::string(error.what()).find("stand in a line"), std::string::npos) << error.what();
            ++refused;
        }
        if (HasFailure()) break;
    }
    EXPECT_LE(refused, 2);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomModels, ::testing::Range(0, 20));

}  // namespace
}  // namespace stratareeb
