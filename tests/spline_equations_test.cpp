// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/spline_equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace stratareeb {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

const CubicKnots kX({0, 1, 1.5, 2, 4, 5}), kY({-1, 0, 2, 2.5});

struct Heights {
    std::vector<Point2> at;
    std::vector<double> z;
};

Heights random_heights(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Heights heights;
    for (int i = 0; i < 600; ++i) {
        heights.at.push_back({5 * unit(random), 3.5 * unit(random) - 1});
        heights.z.push_back(std::sin(3 * heights.at.back().x) + unit(random));
    }
    return heights;
}

void set_up(SplineEquations& equations, const Heights& heights) {
    equations.begin_with_bending(1e-9);
    for (std::size_t i = 0; i < heights.at.size(); ++i) equations.add(heights.at[i], heights.z[i], 1);
}

double height(const std::vector<double>& c, const Point2& p) {
    const auto vx = kX.values(p.x), vy = kY.values(p.y);
    double z = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            z += vx.value[i] * vy.value[j] * c[(vx.first + i) * kY.functions() + vy.first + j];
    return z;
}

double squares(const Heights& heights, const std::vector<double>& c) {
    double sum = 0;
    for (std::size_t i = 0; i < heights.at.size(); ++i)
        sum += std::pow(height(c, heights.at[i]) - heights.z[i], 2);
    return sum;
}

TEST(SplineEquations, reproduce_a_bicubic) {
    const auto f = [](const Point2& p) { return 2 - p.x * p.x * p.x + p.x * p.y * p.y - p.y; };
    Heights heights = random_heights(1);
    for (std::size_t i = 0; i < heights.at.size(); ++i) heights.z[i] = f(heights.at[i]);
    SplineEquations equations(kX, kY);
    equations.begin_with_bending(0);
    for (std::size_t i = 0; i < heights.at.size(); ++i) equations.add(heights.at[i], heights.z[i], 1);
    const auto c = equations.solve();
    for (const Point2 p : {Point2{0.1, -0.9}, {4.9, 2.4}, {1.7, 1}}) EXPECT_NEAR(height(c, p), f(p), 1e-8);
}

TEST(SplineEquations, are_those_of_least_squares_where_limits_are_far) {
    const auto heights = random_heights(2);
    SplineEquations equations(kX, kY);
    set_up(equations, heights);
    const auto c = equations.solve();
    for (const double limit : {1e9, kFree}) {
        std::vector<char> held;
        EXPECT_EQ(equations.solve_below(std::vector<double>(c.size(), limit), held), c);
        EXPECT_EQ(held, std::vector<char>(c.size(), 0));
    }
}

// Of a convex problem the solution is the place from which no single coefficient can move to a better one within its limit.
TEST(SplineEquations, find_the_best_below_limits) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto heights = random_heights(seed);
        SplineEquations equations(kX, kY);
        set_up(equations, heights);
        const auto least = equations.solve();
        std::mt19937_64 random(seed);
        std::vector<double> highest;
        for (const double c : least) {
            const double by = std::uniform_real_distribution<double>(-0.3, 0.5)(random);
            highest.push_back(random() % 3 == 0 ? kFree : c + by);
        }
        std::vector<char> held, other(highest.size(), 0);
        auto c = equations.solve_below(highest, held);
        for (std::size_t i = 0; i < other.size(); ++i) other[i] = highest[i] != kFree && random() % 2 == 0;
        const auto again = equations.solve_below(highest, other);  // from any start
        for (std::size_t i = 0; i < c.size(); ++i) {
            EXPECT_NEAR(c[i], again[i], 1e-9) << seed;
            if (held[i]) {
                EXPECT_NEAR(c[i], highest[i], 1e-12) << seed;
            }
        }
        const double best = squares(heights, c);
        EXPECT_GT(best, squares(heights, least)) << seed;
        for (std::size_t i = 0; i < c.size(); ++i) {
            EXPECT_LE(c[i], highest[i]) << seed;
            for (const double step : {-1e-3, 1e-3}) {
                const double old = c[i];
                c[i] = std::min(old + step, highest[i]);
                EXPECT_GE(squares(heights, c), best * (1 - 1e-9)) << seed << " " << i;
                c[i] = old;
            }
        }
    }
}

TEST(SplineEquations, bend_by_spans_like_all_at_once_where_these_are_unit_squares) {
    const CubicKnots knots({0, 1, 2, 3});
    const auto solve = [&](bool by_spans) {
        SplineEquations equations(knots, knots);
        equations.begin_with_bending(by_spans ? 0 : 0.1);
        for (std::size_t i = 0; by_spans && i < 9; ++i) equations.add_bending_of_span(i / 3, i % 3, 0.1);
        for (const Point2 p : {Point2{0.2, 0.3}, {2.5, 0.1}, {1.1, 2.8}, {2.9, 2.7}})
            equations.add(p, p.x * p.y, 1);
        return equations.solve();
    };
    const auto a = solve(false), b = solve(true);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9);
}

}  // namespace
}  // namespace stratareeb
