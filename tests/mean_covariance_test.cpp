// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/mean_covariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/vecchia_likelihood.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double covariance_at(const MeanCovariance& mean, double r) {
    return mean_covariance_kernel(mean, 0)->at(r);
}

TEST(MeanCovariance, kernel_is_the_sum_that_it_stands_for) {
    const MeanCovariance mean{0.7, {0.5, 0.2, 0, 0.3}, {0.5, 0, 0, 0.1}, 0.4, {}};
    for (const double r : {0.0, 1e-6, 0.03, 0.8, 5.0, 300.0}) {
        double sum = 0;
        for (std::size_t k = 0; k < mean.constant.size(); ++k) {
            const double s = mean.rate * std::pow(2, static_cast<double>(k)) * r;
            sum += (mean.constant[k] + mean.linear[k] * s) * std::exp(-s);
        }
        EXPECT_NEAR(covariance_at(mean, r), sum, 1e-12);
        const double t = r / 0.05, micro = t < 1 ? std::pow(1 - t, 4) * (4 * t + 1) : 0;
        EXPECT_NEAR(mean_covariance_kernel(mean, 0.05)->at(r), sum + 0.4 * micro, 1e-12);
    }
}

// Medians over fields that were drawn with known covariances.
TEST(MeanCovariance, is_near_the_covariance_that_fields_were_drawn_with) {
    for (const Variogram& truth :
         {Variogram{VariogramModel::Exponential, 0.2, 1, 0.4}, Variogram{VariogramModel::Matern32, 0, 1, 0.3},
          Variogram{VariogramModel::Matern32, 0.001, 1, 0.5}}) {
        std::vector<double> nugget, near_by;
        for (std::uint64_t seed = 1; seed <= 11; ++seed) {
            const auto at = places_over_square(seed, 300);
            const auto mean = mean_covariance(at, simulated_field(at, truth, seed + 100), 0);
            nugget.push_back(mean.nugget);
            near_by.push_back(mean.nugget + covariance_at(mean, 0) - covariance_at(mean, 0.1));
        }
        std::ranges::sort(nugget), std::ranges::sort(near_by);
        EXPECT_NEAR(nugget[5], truth.nugget, 0.15 * (truth.nugget + 0.05));
        EXPECT_NEAR(near_by[5], truth.at(0.1), 0.15 * truth.at(0.1));
    }
}

// Thicknesses have long tails. The normal law takes a few wild values for noise everywhere.
TEST(MeanCovariance, is_not_led_astray_by_a_few_wild_values) {
    std::vector<double> share, by_normal_law;
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        const auto at = places_over_square(seed, 200);
        auto value = simulated_field(at, {VariogramModel::Matern32, 0.001, 1, 0.6}, seed);
        for (std::size_t i = 0; i < value.size(); i += 25) value[i] += 6;
        const auto mean = mean_covariance(at, value, 0);
        share.push_back(mean.nugget / (mean.nugget + covariance_at(mean, 0)));
        const VecchiaLikelihood likelihood(at, value, 0);
        const auto smooth =
            likelihood.covariances(*covariance_kernel({VariogramModel::Matern32, 0, 1, 0.6}, 0));
        double sill = 0;
        by_normal_law.push_back(likelihood.misfit(smooth, 0.4, sill) <
                                likelihood.misfit(smooth, 0.025, sill));
    }
    std::ranges::sort(share);
    EXPECT_LT(share[4], 0.3);
    EXPECT_GE(std::ranges::count(by_normal_law, 1.0), 8) << "else the test tells nothing";
}

TEST(MeanCovariance, changes_as_little_as_its_values) {
    for (const std::size_t count : {9, 30, 200}) {
        const auto at = places_over_square(3, count);
        auto value = simulated_field(at, {VariogramModel::Exponential, 0.1, 1, 0.5}, 4);
        const auto before = mean_covariance(at, value, 0);
        for (std::size_t i = 0; i < count; ++i) value[i] += i % 2 ? 1e-9 : -1e-9;
        const auto after = mean_covariance(at, value, 0);
        for (const double r : {0.0, 0.01, 0.1, 1.0})
            EXPECT_NEAR(covariance_at(before, r), covariance_at(after, r), 1e-6);
        EXPECT_NEAR(before.nugget, after.nugget, 1e-6);
    }
}

TEST(MeanCovariance, of_few_or_equal_values_is_a_guess_over_their_extent) {
    const std::vector<Point2> at{{0, 0}, {1, 0}, {0, 1}};
    for (const auto& value : {std::vector<double>{1, 2, 3}, {5, 5, 5}}) {
        const auto mean = mean_covariance(at, value, 0);
        EXPECT_EQ(mean.nugget, 0);
        EXPECT_GT(covariance_at(mean, 0), 0);
        EXPECT_LT(covariance_at(mean, 1), covariance_at(mean, 0.5));
    }
    EXPECT_GT(covariance_at(mean_covariance({}, {}, 0), 0), 0);
}

//! Of the contrasts of some sites, by one dense system: their quadratic form and the logarithm of their determinant.
struct Contrasts {
    double quadratic, logarithm;
};

Contrasts dense_contrasts(const std::vector<Point2>& at, const std::vector<double>& value, const Variogram& v,
                          const std::vector<std::size_t>& sites) {
    const auto n = static_cast<Eigen::Index>(sites.size());
    Eigen::MatrixXd C(n, n);
    Eigen::VectorXd z(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Point2& p = at[sites[static_cast<std::size_t>(i)]];
        z[i] = value[sites[static_cast<std::size_t>(i)]];
        for (Eigen::Index j = 0; j < n; ++j) {
            const Point2& q = at[sites[static_cast<std::size_t>(j)]];
            C(i, j) = v.nugget + v.sill - v.at(p.x - q.x, p.y - q.y);
        }
    }
    const Eigen::LDLT<Eigen::MatrixXd> factor(C);
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(n), solved = factor.solve(one);
    const Eigen::VectorXd rest = z - solved.dot(z) / one.dot(solved) * one;
    return {rest.dot(factor.solve(rest)), factor.vectorD().array().log().sum() + std::log(one.dot(solved))};
}

// With 12 sites each is given all before it, and conditional densities multiply to the joint one of all sites over that of the
// first two of its order. Which those are is its own affair: one pair must fit for all models.
TEST(VecchiaLikelihood, of_few_sites_is_that_of_the_dense_system) {
    const auto at = places_over_square(2, 12);
    const auto value = simulated_field(at, {VariogramModel::Exponential, 0.1, 1, 0.5}, 3);
    const VecchiaLikelihood likelihood(at, value, 0);
    std::vector<std::size_t> all(12);
    std::iota(all.begin(), all.end(), std::size_t{0});
    int fitting = 0;
    for (std::size_t a = 0; a < 12; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            bool fits = true;
            for (const double range : {0.2, 0.8, 3.0}) {
                const Variogram v{VariogramModel::Matern32, 0.3, 0.7, range};
                const auto covariances =
                    likelihood.covariances(*covariance_kernel({v.model, 0, 1, range}, 0));
                double sill = 0;
                const double found = likelihood.misfit(covariances, 0.3, sill);
                const Contrasts of_all = dense_contrasts(at, value, v, all),
                                of_two = dense_contrasts(at, value, v, {a, b});
                const double expected_sill = (of_all.quadratic - of_two.quadratic) / 10;
                fits &= std::abs(sill - expected_sill) < 1e-6 * sill;
                fits &= std::abs(found -
                                 (10 * std::log(expected_sill) + of_all.logarithm - of_two.logarithm)) < 1e-6;
            }
            fitting += fits;
        }
    EXPECT_EQ(fitting, 1);
}

}  // namespace
}  // namespace stratareeb
