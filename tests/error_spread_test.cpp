// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/error_spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"

namespace stratareeb {
namespace {

struct Case {
    Survey survey;
    AnalyticTruth truth;
    LayerModel model;
};

Case made(RandomSurveyOptions options) {
    Case made{random_survey(options), random_truth(options), {}};
    made.model = build_layer_model(made.survey);
    return made;
}

double truth_of(const AnalyticTruth& truth, const PredictedQuantity& quantity, const Point2& at) {
    if (quantity.thickness) return truth.thickness(quantity.index, at);
    double z = truth.ground(at);
    for (std::size_t i = 0; i < quantity.index; ++i) z -= truth.thickness(i, at);
    return z;
}

double model_value(const LayerModel& model, const PredictedQuantity& quantity, std::size_t v) {
    return quantity.thickness ? model.thickness(quantity.index, v)
                              : model.horizons[quantity.index][v] + model.origin.z;
}

Point2 place(const LayerModel& model, std::size_t v) {
    const auto& p = model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
    return {p[0] + model.origin.x, p[1] + model.origin.y};
}

const std::vector<PredictedQuantity> kQuantities{{false, 0}, {false, 2}, {true, 1}};

//! Share of plan vertices at which the interval holds the truth, over surveys of seeds `first` to `last`.
double share_held(RandomSurveyOptions options, std::uint64_t first, std::uint64_t last) {
    std::size_t vertices = 0, held = 0;
    for (options.seed = first; options.seed <= last; ++options.seed) {
        const Case c = made(options);
        for (const PredictedQuantity& quantity : kQuantities) {
            const ErrorSpread spread = error_spread(c.model, c.survey, quantity, Spread::Interval);
            for (std::size_t v = 0; v < spread.size.size(); ++v) {
                const double error =
                    model_value(c.model, quantity, v) - truth_of(c.truth, quantity, place(c.model, v));
                held += std::abs(error) <= spread.size[v] + 0.002;  // logs are rounded to a millimetre
                ++vertices;
            }
        }
    }
    return static_cast<double>(held) / static_cast<double>(vertices);
}

TEST(ErrorSpread, intervals_hold_the_truth_between_the_holes) {
    const double share = share_held({.holes = 60}, 301, 303);
    RecordProperty("coverage", std::to_string(share));
    EXPECT_GT(share, 0.93);
}

TEST(ErrorSpread, intervals_hold_the_truth_between_groups_of_holes) {
    const double share = share_held({.holes = 80, .plan = HolePlan::Clustered}, 311, 316);
    RecordProperty("coverage", std::to_string(share));
    EXPECT_GT(share, 0.88);  // left out one by one, the holes of a group predict each other: 0.69
}

TEST(ErrorSpread, standard_deviation_is_of_the_size_of_errors) {
    double squares = 0, expected = 0;
    for (std::uint64_t seed = 401; seed <= 403; ++seed) {
        const Case c = made({.holes = 60, .seed = seed});
        for (const PredictedQuantity& quantity : kQuantities) {
            const ErrorSpread spread = error_spread(c.model, c.survey, quantity, Spread::Deviation);
            for (std::size_t v = 0; v < spread.size.size(); ++v) {
                squares += std::pow(
                    model_value(c.model, quantity, v) - truth_of(c.truth, quantity, place(c.model, v)), 2);
                expected += std::pow(spread.size[v], 2);
            }
        }
    }
    RecordProperty("ratio", std::to_string(std::sqrt(squares / expected)));
    EXPECT_GT(std::sqrt(squares / expected), 0.5);  // held-out holes are farther from others than most places
    EXPECT_LT(std::sqrt(squares / expected), 1.1);
}

TEST(ErrorSpread, is_0_at_the_holes_and_grows_away_from_them) {
    const Case c = made({.holes = 40, .seed = 7});
    for (const Spread kind : {Spread::Deviation, Spread::Interval}) {
        const ErrorSpread spread = error_spread(c.model, c.survey, {true, 0}, kind);
        double most = 0;
        for (const double size : spread.size) most = std::max(most, size);
        EXPECT_GT(most, 0);
        for (const std::uint32_t v : c.model.plan.hole_vertex) EXPECT_EQ(spread.size[v], 0);
    }
}

TEST(ErrorSpread, is_0_where_boreholes_predict_each_other_without_error) {
    const Case c = made({.holes = 40, .seed = 3, .truth = TruthKind::Slab});
    const ErrorSpread spread = error_spread(c.model, c.survey, {true, 1}, Spread::Interval);
    for (const double size : spread.size) EXPECT_LT(size, 1e-6);
}

TEST(ErrorSpread, does_not_depend_on_far_coordinates) {
    const Case near = made({.holes = 40, .seed = 5}),
               far = made({.holes = 40, .seed = 5, .corner = {5e6, 5e6}});
    const auto a = error_spread(near.model, near.survey, {true, 1}, Spread::Deviation);
    const auto b = error_spread(far.model, far.survey, {true, 1}, Spread::Deviation);
    ASSERT_EQ(a.errors, b.errors);
    double most_a = 0, most_b = 0;
    for (const double size : a.size) most_a = std::max(most_a, size);
    for (const double size : b.size) most_b = std::max(most_b, size);
    EXPECT_NEAR(most_a, most_b, 0.02 * most_a);
}

TEST(ErrorSpread, needs_five_boreholes_that_know) {
    const Case c = made({.holes = 4, .seed = 1});
    EXPECT_THROW(error_spread(c.model, c.survey, {true, 0}, Spread::Interval), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
