// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/spline_basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::Random;

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(SplineBasis, bernstein_polynomials_are_the_binomial_distribution) {
    Random random(1);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t n = random.below(20);
        const double t = random.uniform(0, 1);
        const auto basis = bernstein_basis(n, t);
        ASSERT_EQ(basis.size(), n + 1);
        double choose = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            EXPECT_NEAR(
                basis[k],
                choose * std::pow(t, static_cast<double>(k)) * std::pow(1 - t, static_cast<double>(n - k)),
                1e-13);
            choose = choose * static_cast<double>(n - k) / static_cast<double>(k + 1);
        }
    }
}

TEST(SplineBasis, bernstein_polynomials_of_high_degree_keep_their_mean) {
    for (const double t : {1e-300, 1e-9, 0.25, 0.5, 0.999, 1 - 1e-16}) {
        const std::size_t n = 5000;
        const auto basis = bernstein_basis(n, t);
        EXPECT_NEAR(sum(basis), 1, 1e-12);
        double mean = 0;
        for (std::size_t k = 0; k <= n; ++k) mean += static_cast<double>(k) * basis[k];
        EXPECT_NEAR(mean, static_cast<double>(n) * t, 1e-8);
    }
}

//! The definition, function by function: N of degree 0 on half-open spans, then the recursion from degree 1 with 0/0 = 0.
double recursive_basis(const std::vector<double>& knots, std::size_t i, std::size_t k, double x) {
    if (k == 0) return knots[i] <= x && x < knots[i + 1] ? 1 : 0;
    const double a = knots[i + k] - knots[i], b = knots[i + k + 1] - knots[i + 1];
    return (a > 0 ? (x - knots[i]) / a * recursive_basis(knots, i, k - 1, x) : 0) +
           (b > 0 ? (knots[i + k + 1] - x) / b * recursive_basis(knots, i + 1, k - 1, x) : 0);
}

std::vector<double> random_knots(Random& random, std::size_t points, std::size_t degree) {
    std::vector<double> knots(points + degree + 1);
    for (auto& knot : knots) knot = std::floor(random.uniform(0, 8));  // repeated ones too
    std::sort(knots.begin(), knots.end());
    return knots;
}

TEST(SplineBasis, bsplines_follow_their_recursion_and_add_up_to_one) {
    Random random(2);
    int tried = 0;
    while (tried < 3000) {
        const std::size_t degree = random.below(5), points = degree + 1 + random.below(6);
        const auto knots = random_knots(random, points, degree);
        if (!(knots[degree] < knots[points])) continue;
        ++tried;
        const double x = random.uniform(knots[degree], knots[points]);
        const auto basis = bspline_basis(knots, degree, x);
        EXPECT_NEAR(sum(basis.values), 1, 1e-12);
        EXPECT_NEAR(sum(basis.slopes), 0, 1e-11);
        for (std::size_t i = 0; i < points; ++i) {
            const bool inside = i >= basis.first && i <= basis.first + degree;
            EXPECT_NEAR(inside ? basis.values[i - basis.first] : 0, recursive_basis(knots, i, degree, x),
                        1e-12);
        }
    }
}

TEST(SplineBasis, bsplines_add_up_to_one_at_every_knot_and_at_both_ends) {
    const std::vector<double> knots{0, 0, 0, 1, 1, 2.5, 4, 4, 4};
    for (const double x : knots) {
        const auto basis = bspline_basis(knots, 2, x);
        EXPECT_DOUBLE_EQ(sum(basis.values), 1) << x;
    }
    EXPECT_EQ(bspline_basis(knots, 2, 0).values[0], 1);
    EXPECT_EQ(bspline_basis(knots, 2, 4).values[2], 1);
    EXPECT_EQ(bspline_basis(knots, 2, 4).first, 3u);
}

TEST(SplineBasis, slopes_are_the_difference_quotients) {
    const std::vector<double> knots{0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3};
    const double h = 1e-6;
    for (double x = 0.05; x < 3; x += 0.1) {
        const auto low = bspline_basis(knots, 3, x - h), high = bspline_basis(knots, 3, x + h);
        if (low.first != high.first) continue;
        const auto basis = bspline_basis(knots, 3, x);
        for (std::size_t r = 0; r < 4; ++r) {
            EXPECT_NEAR(basis.slopes[r], (high.values[r] - low.values[r]) / (2 * h), 1e-8);
        }
    }
}

}  // namespace
}  // namespace stratareeb
