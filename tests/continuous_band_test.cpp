// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/continuous_band.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

SampledCurve circle(double radius, double z, std::vector<double> parameters) {
    const auto at = [=](double t) {
        const double angle = 2 * std::numbers::pi * t;
        return Point3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    return {.at = at, .parameters = std::move(parameters)};
}

TEST(ContinuousBand, samples_each_curve_at_the_parameters_of_both) {
    const ContinuousBand band =
        continuous_band(circle(1, 1, {0.5, 0, 0.25, 1.75}), circle(2, 0, {0.9, 0.25, 1.0}));
    EXPECT_EQ(band.upper_parameters, (std::vector<double>{0, 0.25, 0.5, 0.75, 0.9}));
    EXPECT_EQ(band.lower_parameters, band.upper_parameters);
    EXPECT_EQ(band.upper.size(), 5u);
    EXPECT_EQ(band.band.triangles.size(), 10u);
}

TEST(ContinuousBand, path_is_monotone_and_winds_once) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int run = 0; run < 300; ++run) {
        std::vector<double> s(3 + random() % 20), t(3 + random() % 20);
        for (double& parameter : s) parameter = share(random);
        for (double& parameter : t) parameter = share(random);
        for (const bool closed : {true, false})
            for (const BandCost cost : {BandCost::Area, BandCost::SpanLength, BandCost::ParameterDistance}) {
                const auto path =
                    continuous_band(circle(1, 1, s), circle(2, 0, t), {.cost = cost, .closed = closed})
                        .path();
                for (std::size_t k = 1; k < path.size(); ++k) {
                    EXPECT_GE(path[k][0], path[k - 1][0]);
                    EXPECT_GE(path[k][1], path[k - 1][1]);
                    EXPECT_NE(path[k], path[k - 1]);
                }
                EXPECT_NEAR(path.back()[0] - path.front()[0], 1, 1e-12);
                EXPECT_NEAR(path.back()[1] - path.front()[1], 1, 1e-12);
            }
    }
}

TEST(ContinuousBand, both_distance_functions_join_equal_parameters_of_coaxial_circles) {
    std::vector<double> s, t;
    for (int i = 0; i < 20; ++i) s.push_back(i / 20.0), t.push_back((i + 0.3) / 20.0);
    for (const BandCost cost : {BandCost::SpanLength, BandCost::ParameterDistance}) {
        const ContinuousBand band = continuous_band(circle(1, 1, s), circle(1, 0, t), {.cost = cost});
        EXPECT_EQ(band.band.triangles.size(), 80u);
        std::size_t equal = 0;
        for (const auto& [upper, lower] : band.path())
            equal += std::abs(std::remainder(upper - lower, 1)) < 1e-12;
        EXPECT_GE(equal, 40u);  // every second span of 80
    }
}

TEST(ContinuousBand, area_comes_near_that_of_the_cylinder_and_the_cone) {
    double before = 1;
    for (const int count : {10, 20, 40, 80}) {
        std::vector<double> s, t;
        for (int i = 0; i < count; ++i) s.push_back(double(i) / count), t.push_back((i + 0.5) / count);
        const double cylinder = continuous_band(circle(1, 3, s), circle(1, 0, t)).band.path.cost;
        const double error = std::abs(cylinder - 6 * std::numbers::pi) / (6 * std::numbers::pi);
        EXPECT_LT(error, before / 3.5);  // second order
        before = error;
        const double cone = continuous_band(circle(1, 3, s), circle(3, 0, t)).band.path.cost;
        EXPECT_NEAR(cone / (std::numbers::pi * 4 * std::hypot(3, 2)), 1, 2 * error + 1e-3);
    }
}

TEST(ContinuousBand, refuses_parameters_that_are_none) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(continuous_band(circle(1, 1, {}), circle(1, 0, {})), InvalidInput);
    EXPECT_THROW(continuous_band(circle(1, 1, {nan}), circle(1, 0, {0})), InvalidInput);
    EXPECT_THROW(continuous_band(circle(1, 1, {0.5, 1.5}), circle(1, 0, {0}), {.closed = false}),
                 InvalidInput);
}

}  // namespace
}  // namespace stratareeb
