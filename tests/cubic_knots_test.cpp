// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cubic_knots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace stratareeb {
namespace {

// From even spans to some a million times as long as others.
class RandomKnots : public testing::TestWithParam<int> {
 protected:
    RandomKnots() {
        std::uniform_real_distribution<double> exponent(-GetParam() % 7, 0);
        std::vector<double> breaks{-3};
        const int spans = 1 + GetParam() % 40;
        for (int i = 0; i < spans; ++i) breaks.push_back(breaks.back() + std::pow(10, exponent(random)));
        knots = CubicKnots(std::move(breaks));
    }

    double knot(std::size_t i) const {  // four-fold at both ends
        const auto& breaks = knots.breaks();
        return breaks[std::min(i - std::min<std::size_t>(i, 3), breaks.size() - 1)];
    }

    // The definition.
    double basis(std::size_t i, std::size_t degree, double t) const {
        if (degree == 0) return knot(i) <= t && t < knot(i + 1) ? 1 : 0;
        const double a = knot(i + degree) - knot(i), b = knot(i + degree + 1) - knot(i + 1);
        return (a > 0 ? (t - knot(i)) / a * basis(i, degree - 1, t) : 0) +
               (b > 0 ? (knot(i + degree + 1) - t) / b * basis(i + 1, degree - 1, t) : 0);
    }

    double slope(std::size_t i, std::size_t degree, double t) const {
        const double a = knot(i + degree) - knot(i), b = knot(i + degree + 1) - knot(i + 1);
        const double n = static_cast<double>(degree);
        return (a > 0 ? n / a * basis(i, degree - 1, t) : 0) -
               (b > 0 ? n / b * basis(i + 1, degree - 1, t) : 0);
    }

    double bend(std::size_t i, double t) const {
        const double a = knot(i + 3) - knot(i), b = knot(i + 4) - knot(i + 1);
        return (a > 0 ? 3 / a * slope(i, 2, t) : 0) - (b > 0 ? 3 / b * slope(i + 1, 2, t) : 0);
    }

    double somewhere() { return std::uniform_real_distribution<double>(knots.low(), knots.high())(random); }

    std::mt19937 random{static_cast<unsigned>(GetParam())};
    CubicKnots knots{{0, 1}};
};

TEST_P(RandomKnots, functions_follow_their_definition) {
    for (int k = 0; k < 50; ++k) {
        const double t = somewhere();
        const auto& breaks = knots.breaks();
        const std::size_t s = knots.span(t);
        double shortest = INFINITY;
        for (std::size_t i = s - std::min<std::size_t>(s, 2); i <= std::min(s + 2, knots.spans() - 1); ++i)
            shortest = std::min(shortest, breaks[i + 1] - breaks[i]);
        const auto values = knots.values(t), slopes = knots.values(t, 1), bends = knots.values(t, 2);
        for (std::size_t i = 0; i < knots.functions(); ++i) {
            const bool counts = i >= values.first && i < values.first + 4;
            const auto of = [&](const CubicKnots::Values& v) { return counts ? v.value[i - v.first] : 0; };
            EXPECT_NEAR(of(values), basis(i, 3, t), 1e-13);
            EXPECT_NEAR(of(slopes), slope(i, 3, t), 1e-12 / shortest);
            EXPECT_NEAR(of(bends), bend(i, t), 1e-11 / shortest / shortest);
        }
    }
}

TEST_P(RandomKnots, places_are_found_in_their_spans) {
    const auto& breaks = knots.breaks();
    std::vector<double> places{knots.low() - 1, knots.high() + 1, -1e300, 1e300, -INFINITY, INFINITY};
    for (const double b : breaks)
        places.insert(places.end(), {b, std::nextafter(b, -INFINITY), std::nextafter(b, INFINITY)});
    for (int k = 0; k < 200; ++k) places.push_back(somewhere());
    for (const double t : places) {
        std::size_t expected = 0;
        while (expected + 1 < knots.spans() && breaks[expected + 1] <= t) ++expected;
        EXPECT_EQ(knots.span(t), expected) << t;
    }
}

TEST_P(RandomKnots, cubics_are_reproduced_in_and_beyond_all_spans) {
    // Blossoms of (t - m)^3 at three consecutive knots.
    const double m = (knots.low() + knots.high()) / 2, reach = knots.high() - knots.low();
    std::vector<double> coefficients;
    for (std::size_t i = 0; i < knots.functions(); ++i)
        coefficients.push_back((knot(i + 1) - m) * (knot(i + 2) - m) * (knot(i + 3) - m));
    const auto& breaks = knots.breaks();
    const double first = breaks[1] - breaks[0], last = reach + knots.low() - breaks[breaks.size() - 2];
    for (const double t : {somewhere(), somewhere(), knots.low() - first / 2, knots.high() + last / 2}) {
        const double u = t - m;
        EXPECT_NEAR(knots.evaluate(coefficients, t), u * u * u, 1e-12 * std::pow(reach, 3));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomKnots, testing::Range(0, 60));

}  // namespace
}  // namespace stratareeb
