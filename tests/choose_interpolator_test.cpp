// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/choose_interpolator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

//! A layer over a square of 1000 with a thickness by place.
template <class F>
Survey survey_of(std::uint64_t seed, std::size_t count, const F& thickness) {
    Survey survey;
    survey.units = {{"sand", "sand", ""}};
    for (const Point2& p : places_over_square(seed, count)) {
        Borehole hole;
        hole.at = {1000 * p.x, 1000 * p.y};
        hole.layers = {{Knowledge::Measured, thickness(p)}};
        hole.horizons = {0.0, -hole.layers[0].thickness};
        survey.holes.push_back(hole);
    }
    return survey;
}

double error_of(const InterpolatorChoice& choice, InterpolatorKind kind) {
    return std::ranges::find(choice.scores, kind, &InterpolatorScore::kind)->ratio;
}

TEST(ChooseInterpolator, takes_a_smooth_method_for_a_smooth_layer_and_says_why) {
    const auto survey =
        survey_of(1, 80, [](const Point2& p) { return 20 + 5 * std::sin(6 * p.x) * std::cos(5 * p.y); });
    const auto choice = choose_interpolator(survey);
    EXPECT_NE(choice.kind, InterpolatorKind::Linear);
    EXPECT_LT(error_of(choice, choice.kind), 0.6);
    EXPECT_EQ(error_of(choice, InterpolatorKind::Linear), 1);
    EXPECT_EQ(choice.quantities, (std::vector<std::string>{"thickness of 'sand'", "base of 'sand'"}));
    EXPECT_EQ(choice.held_out, (std::vector<std::size_t>{80, 80}));
    EXPECT_EQ(choice.reason.find(std::string(name_of(choice.kind)) +
                                 " has the least error at 80 held-out holes in 10 folds"),
              0u)
        << choice.reason;
}

TEST(ChooseInterpolator, does_not_follow_noise) {
    std::mt19937_64 random(3);
    const auto survey = survey_of(2, 120, [&](const Point2&) { return 20 + normal_number(random); });
    const auto choice = choose_interpolator(survey);
    EXPECT_TRUE(choice.kind == InterpolatorKind::Kriging || choice.kind == InterpolatorKind::KrigingLinear)
        << choice.reason;
    EXPECT_LT(error_of(choice, choice.kind), 0.95);
}

// Leave-one-out by hand: as many folds as holes.
TEST(ChooseInterpolator, measures_what_left_out_holes_show) {
    const auto survey = survey_of(4, 25, [](const Point2& p) { return 20 + 5 * p.x * p.x + p.y; });
    const auto choice = choose_interpolator(
        survey, {.candidates = {InterpolatorKind::NaturalNeighbour}, .folds = 25, .bare = true});
    double sum = 0;
    for (std::size_t out = 0; out < 25; ++out) {
        std::vector<Point2> at;
        std::vector<double> value;
        for (std::size_t h = 0; h < 25; ++h)
            if (h != out)
                at.push_back(survey.holes[h].at), value.push_back(survey.holes[h].layers[0].thickness);
        const double z = predicted(InterpolatorKind::NaturalNeighbour, at, value, {survey.holes[out].at})[0];
        sum += std::pow(z - survey.holes[out].layers[0].thickness, 2);
    }
    EXPECT_NEAR(choice.scores[0].rmse[0], std::sqrt(sum / 25), 1e-12);
}

TEST(ChooseInterpolator, is_the_same_each_time_and_bounds_its_work) {
    const Survey survey = random_survey({.holes = 300, .layers = 2, .pinch_outs = true});
    const ChooseOptions options{.most_holes = 60};
    const auto one = choose_interpolator(survey, options), other = choose_interpolator(survey, options);
    EXPECT_EQ(one.reason, other.reason);
    EXPECT_EQ(one.held_out, (std::vector<std::size_t>{60, 60, 60, 60}));
    for (std::size_t c = 0; c < one.scores.size(); ++c) EXPECT_EQ(one.scores[c].rmse, other.scores[c].rmse);
}

TEST(ChooseInterpolator, copes_with_holes_at_one_place_and_with_hardly_any) {
    auto survey = survey_of(5, 30, [](const Point2& p) { return 20 + p.x; });
    survey.holes.push_back(survey.holes[3]);
    survey.holes.back().layers[0].thickness = 500;
    EXPECT_EQ(choose_interpolator(survey).held_out, (std::vector<std::size_t>{30, 30}));
    survey.holes.resize(3);
    const auto choice = choose_interpolator(survey);
    EXPECT_EQ(choice.kind, InterpolatorKind::Linear);
    EXPECT_EQ(choice.reason, "linear: too few holes to compare methods on");
    EXPECT_EQ(choose_interpolator({}).kind, InterpolatorKind::Linear);
}

TEST(ChooseInterpolator, judges_contact_points_by_elevation) {
    Survey survey;
    survey.contact_points = true;
    survey.units = {{"a", "a", ""}};
    for (const Point2& p : places_over_square(6, 60)) {
        Borehole hole;
        hole.at = p;
        hole.horizons = {7.0, -3 * std::sin(5 * p.x)};
        survey.holes.push_back(hole);
    }
    const auto choice = choose_interpolator(survey);
    EXPECT_EQ(choice.quantities, (std::vector<std::string>{"elevation of the ground", "base of 'a'"}));
    EXPECT_LT(error_of(choice, choice.kind), 0.6);
}

TEST(ChooseInterpolator, leaves_complaints_about_the_table_to_the_model) {
    auto survey = survey_of(7, 40, [](const Point2& p) { return 20 + p.x; });
    for (std::size_t h = 0; h < 40; ++h)
        if (h != 3) survey.holes[h].horizons.clear();  // one ground: without that hole there is none
    const auto choice = choose_interpolator(survey);
    EXPECT_EQ(choice.kind, InterpolatorKind::Linear);
    EXPECT_TRUE(choice.quantities.empty());
}

TEST(ChooseInterpolator, refuses_no_candidates_and_one_fold) {
    EXPECT_THROW(choose_interpolator({}, {.candidates = {}}), InvalidInput);
    EXPECT_THROW(choose_interpolator({}, {.folds = 1}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
