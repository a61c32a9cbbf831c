// SPDX-License-Identifier: GPL-3.0-or-later
// Random layer models over footprints that are not the holes' hull, under terrains, and from contact points.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "mesh/layer_model.h"
#include "tests/model_soundness.h"

namespace stratareeb {
namespace {

constexpr double kExtent = 300;

class Dice {
 public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    std::uint64_t below(std::uint64_t n) { return random_() % n; }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }

 private:
    std::mt19937_64 random_;
};

//! A star-shaped outline around a place anywhere near the holes, often with a star-shaped window.
Footprint random_star(Dice& dice, const Point2& corner) {
    const Point2 middle{corner.x + kExtent * dice.between(0.2, 0.8),
                        corner.y + kExtent * dice.between(0.2, 0.8)};
    const std::size_t corners = 3 + dice.below(20);
    const double radius = kExtent * dice.between(0.2, 0.9);
    Footprint star(1 + dice.below(2));
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        const double outer = radius * dice.between(0.6, 1), inner = radius * dice.between(0.1, 0.25);
        star[0].push_back({middle.x + outer * std::cos(angle), middle.y + outer * std::sin(angle)});
        if (star.size() > 1)
            star[1].push_back({middle.x + inner * std::cos(angle), middle.y + inner * std::sin(angle)});
    }
    return star;
}

Footprint random_footprint(Dice& dice, const Survey& survey, const Point2& corner) {
    if (dice.below(3) > 0) return random_star(dice, corner);
    std::vector<Point2> holes;
    for (const Borehole& hole : survey.holes) holes.push_back(hole.at);
    return box_footprint(holes, kExtent * dice.between(0.001, 0.5));
}

RandomSurveyOptions random_survey_options(Dice& dice, std::uint64_t seed) {
    RandomSurveyOptions options{.holes = 3 + dice.below(30), .layers = 1 + dice.below(4), .seed = seed};
    options.plan =
        std::array{HolePlan::Random, HolePlan::Clustered, HolePlan::Grid, HolePlan::Line}[dice.below(4)];
    options.pinch_outs = dice.below(2);
    options.zero_share = dice.between(0, 0.6);
    options.unknown_share = dice.between(0, 0.3);
    options.cut_off_share = dice.between(0, 0.4);
    if (dice.below(2)) options.corner = {5e6, 4.9e6};
    return options;
}

LayerModelOptions random_model_options(Dice& dice) {
    LayerModelOptions options;
    options.interpolator = dice.below(2) ? InterpolatorKind::Linear : InterpolatorKind::NaturalNeighbour;
    options.pinch_out.fraction = std::array{0.0, 0.25, 1.0 / 3, 0.5}[dice.below(4)];
    options.spacing = dice.below(4) ? kExtent * dice.between(0.06, 0.2) : 0;
    return options;
}

class Seeds : public ::testing::TestWithParam<std::uint64_t> {
 protected:
    static constexpr std::uint64_t kPerTest = 8;
    template <class Check>
    static void for_each_seed(Check check) {
        for (std::uint64_t seed = kPerTest * GetParam() + 1; seed <= kPerTest * (GetParam() + 1); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Dice dice(seed);
            check(dice, seed);
            if (HasFailure()) break;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(Random, Seeds, ::testing::Range<std::uint64_t>(0, 8));

TEST_P(Seeds, footprints_of_any_shape_carry_sound_models) {
    for_each_seed([](Dice& dice, std::uint64_t seed) {
        const auto survey_options = random_survey_options(dice, seed);
        const Survey survey = random_survey(survey_options);
        LayerModelOptions options = random_model_options(dice);
        options.footprint = random_footprint(dice, survey, survey_options.corner);
        const LayerModel model = build_layer_model(survey, options);
        testing::expect_sound(model, survey);
        double plan = 0;
        for (const auto f : model.plan.surface.faces()) plan += model.plan.surface.calc_face_area(f);
        const double expected = area(checked_footprint(*options.footprint));
        EXPECT_NEAR(plan, expected, 1e-9 * expected);
    });
}

// Here pinch-out lines are edges of the triangulation: each must end in one place on the outline.
TEST_P(Seeds, outlines_cut_the_bare_triangulation_and_its_pinch_out_lines_alike) {
    for_each_seed([](Dice& dice, std::uint64_t seed) {
        const auto survey_options = random_survey_options(dice, seed);
        const Survey survey = random_survey(survey_options);
        LayerModelOptions options{.pinch_out = {0}, .spacing = 0.0};
        options.footprint = random_star(dice, survey_options.corner);
        testing::expect_sound(build_layer_model(survey, options), survey);
    });
}

TEST_P(Seeds, terrains_of_any_shape_carry_sound_models) {
    for_each_seed([](Dice& dice, std::uint64_t seed) {
        auto survey_options = random_survey_options(dice, seed + 1000);
        survey_options.plan = HolePlan::Random;
        Survey survey = random_survey(survey_options);
        const bool has_gap = dice.below(2);
        for (Borehole& hole : survey.holes)
            if (dice.below(3) == 0) hole.horizons.assign(survey.units.size() + 1, std::nullopt);
        survey.holes[0].horizons[0] = 100;
        const Point2 corner = survey_options.corner;
        LayerModelOptions options = random_model_options(dice);
        options.terrain = [=](const Point2& p) -> std::optional<double> {
            if (has_gap && p.x - corner.x > 200) return std::nullopt;
            return 100 + 40 * std::sin((p.x - corner.x) / 15) * std::cos((p.y - corner.y) / 11);
        };
        testing::expect_sound(build_layer_model(survey, options), survey);
    });
}

TEST_P(Seeds, contact_points_in_any_disorder_carry_sound_models) {
    for_each_seed([](Dice& dice, std::uint64_t) {
        Survey survey;
        survey.contact_points = true;
        const std::size_t units = 1 + dice.below(4);
        for (std::size_t i = 0; i < units; ++i) survey.units.push_back({std::to_string(i), "", "#777777"});
        const std::size_t count = 4 * (units + 1) + dice.below(60);
        for (std::size_t n = 0; n < count; ++n) {
            Borehole hole;
            const std::size_t k = n % (units + 1);
            hole.at = {kExtent * dice.between(0, 1), kExtent * dice.between(0, 1)};
            hole.layers.resize(units);
            hole.horizons.resize(units + 1);
            hole.horizons[k] = -8.0 * static_cast<double>(k) + dice.between(0, 20);
            survey.holes.push_back(hole);
        }
        const LayerModel model = build_layer_model(survey, random_model_options(dice));
        testing::expect_sound(model, survey);
        for (std::size_t h = 0; h < survey.holes.size(); ++h) {
            const auto v = model.plan.hole_vertex[h];
            if (v == PlanMesh::kNoVertex) continue;
            for (std::size_t k = 0; k <= units; ++k)
                if (const auto z = survey.holes[h].horizons[k]) {
                    EXPECT_NEAR(model.horizons[k][v] + model.origin.z, *z, 1e-9 * kExtent);
                }
        }
    });
}

}  // namespace
}  // namespace stratareeb
