// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/variogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "boreholes/errors.h"
#include "boreholes/fit_variogram.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

const std::vector<VariogramModel> kModels{VariogramModel::Spherical, VariogramModel::Exponential,
                                          VariogramModel::Gaussian, VariogramModel::Matern32,
                                          VariogramModel::Matern52};

TEST(Variogram, has_names_for_its_models) {
    for (const auto model : kModels) EXPECT_EQ(variogram_model(name_of(model)), model);
    EXPECT_THROW(variogram_model("cubic"), InvalidInput);
}

TEST(Variogram, rises_from_the_nugget_to_the_sill_within_its_range) {
    for (const auto model : kModels) {
        const Variogram v{model, 0.5, 2, 10};
        EXPECT_EQ(v.at(0), 0);
        EXPECT_NEAR(v.at(1e-9), 0.5, 1e-8);
        EXPECT_NEAR(v.at(10), 0.5 + 2 * (model == VariogramModel::Spherical ? 1 : 0.95), 1e-3);
        EXPECT_NEAR(v.at(1000), 2.5, 1e-12);
        for (double h = 0.5; h < 30; h += 0.5) EXPECT_LE(v.at(h), v.at(h + 0.5));
    }
    EXPECT_DOUBLE_EQ((Variogram{VariogramModel::Spherical, 0, 1, 2}).at(1), 0.6875);
}

TEST(Variogram, stretches_along_its_angle) {
    const Variogram v{VariogramModel::Exponential, 0, 1, 4, 0.5, std::numbers::pi / 2};
    EXPECT_NEAR(v.at(0, 3), v.at(3), 1e-15);
    EXPECT_NEAR(v.at(3, 0), v.at(6), 1e-15);
}

TEST(Variogram, of_an_experiment_is_the_mean_half_square_of_its_pairs) {
    const std::vector<Point2> at{{0, 0}, {1, 0}, {3, 0}};
    const std::vector<double> value{0, 2, 8};
    const auto bins = experimental_variogram(at, value, 4, 4);
    ASSERT_EQ(bins.size(), 3u);
    EXPECT_EQ(bins[0].distance, 1);
    EXPECT_EQ(bins[0].gamma, 2);
    EXPECT_EQ(bins[1].gamma, 18);
    EXPECT_EQ(bins[2].gamma, 32);
    EXPECT_EQ(bins[2].pairs, 1);
}

TEST(Variogram, of_exact_bins_is_found_again_by_least_squares) {
    for (const auto model : kModels) {
        const Variogram truth{model, 0.3, 1.7, 0.8};
        std::vector<VariogramBin> bins;
        for (int k = 1; k <= 15; ++k) bins.push_back({0.1 * k, truth.at(0.1 * k), 100});
        const Variogram found = fit_to_bins(bins, model);
        EXPECT_NEAR(found.range, truth.range, 0.05 * truth.range) << name_of(model);
        EXPECT_NEAR(found.sill, truth.sill, 0.05) << name_of(model);
        EXPECT_NEAR(found.nugget, truth.nugget, 0.05) << name_of(model);
    }
    EXPECT_EQ(fit_to_bins({}, VariogramModel::Spherical).nugget, 0);
}

// Medians over fields that were drawn with known parameters.
TEST(FitVariogram, finds_the_parameters_that_fields_were_drawn_with) {
    for (const auto model :
         {VariogramModel::Exponential, VariogramModel::Spherical, VariogramModel::Matern32}) {
        const Variogram truth{model, 0.2, 1, 0.4};
        std::vector<double> nugget, total, range;
        for (std::uint64_t seed = 1; seed <= 15; ++seed) {
            const auto at = places_over_square(seed, 300);
            const auto v = fit_variogram(at, simulated_field(at, truth, seed + 100), {.models = {model}});
            nugget.push_back(v.nugget), total.push_back(v.nugget + v.sill),
                range.push_back(v.range * std::sqrt(v.ratio));
        }
        for (auto* list : {&nugget, &total, &range}) std::ranges::sort(*list);
        EXPECT_NEAR(nugget[7], 0.2, 0.07) << name_of(model);
        EXPECT_NEAR(total[7], 1.2, 0.35) << name_of(model);
        EXPECT_NEAR(range[7], 0.4, 0.15) << name_of(model);
    }
}

TEST(FitVariogram, sees_which_way_a_field_is_drawn_out) {
    std::vector<double> ratio, turn;
    for (std::uint64_t seed = 1; seed <= 11; ++seed) {
        const auto at = places_over_square(seed, 300);
        const Variogram truth{VariogramModel::Exponential, 0.05, 1, 0.9, 0.3, 0.5};
        const auto v = fit_variogram(at, simulated_field(at, truth, seed + 100));
        ratio.push_back(v.ratio);
        turn.push_back(std::abs(std::remainder(v.angle - truth.angle, std::numbers::pi)));
    }
    std::ranges::sort(ratio), std::ranges::sort(turn);
    EXPECT_NEAR(ratio[5], 0.3, 0.15);
    EXPECT_LT(turn[5], 0.15);
}

TEST(FitVariogram, tells_smooth_fields_from_rough_ones_and_noise) {
    int smooth = 0, rough = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto at = places_over_square(seed, 250);
        const auto model_of = [&](VariogramModel model) {
            return fit_variogram(at, simulated_field(at, {model, 0, 1, 0.5}, seed + 50)).model;
        };
        const auto of_smooth = model_of(VariogramModel::Matern52),
                   of_rough = model_of(VariogramModel::Exponential);
        smooth += of_smooth == VariogramModel::Matern52 || of_smooth == VariogramModel::Gaussian ||
                  of_smooth == VariogramModel::Matern32;
        rough += of_rough == VariogramModel::Exponential || of_rough == VariogramModel::Spherical;
        std::mt19937_64 random(seed);
        std::vector<double> noise;
        for (std::size_t i = 0; i < at.size(); ++i) noise.push_back(normal_number(random));
        const Variogram v = fit_variogram(at, noise);
        EXPECT_GT(v.at(0.1), 0.7 * v.at(0.7)) << "values that know nothing of each other, seed " << seed;
    }
    EXPECT_GE(smooth, 9);
    EXPECT_GE(rough, 9);
}

TEST(FitVariogram, has_an_answer_for_few_and_equal_values) {
    const auto at = places_over_square(1, 20);
    for (const Variogram& v : {fit_variogram({}, {}), fit_variogram(at, std::vector<double>(20, 3.0)),
                               fit_variogram(std::span(at).first(3), std::vector<double>{1, 2, 3})}) {
        EXPECT_EQ(v.nugget, 0);
        EXPECT_GT(v.sill, 0);
        EXPECT_GT(v.range, 0);
    }
}

}  // namespace
}  // namespace stratareeb
