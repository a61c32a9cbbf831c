// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

TEST(CapProfile, goes_from_the_point_to_the_contour_with_the_slope_asked_for) {
    for (const double slope : {-1.0, -0.4, 0.0, 0.2, 0.5, 0.9, 1.0, 1.5, 1.8}) {
        const CapProfile cap = CapProfile::conic(slope);
        EXPECT_EQ(cap.width(0), 0);
        EXPECT_DOUBLE_EQ(cap.width(1), 1);
        constexpr double kStep = 1e-7;
        EXPECT_NEAR((cap.width(1) - cap.width(1 - kStep)) / kStep, slope, 1e-5);
        EXPECT_GT(cap.width(1e-8) / 1e-8, 100) << "level at the point";
        double most = 0;
        for (double x = 0.001; x < 0.9995; x += 0.001) {
            most = std::max(most, cap.width(x));
            const double least = slope >= 0 ? cap.width(x) : 0;
            EXPECT_LT(least, cap.width(x + 0.001) + 1e-15) << slope << " at " << x;
        }
        EXPECT_LT(most, slope < 0 ? 1.16 : 1);
    }
    EXPECT_DOUBLE_EQ(CapProfile::conic(7).width(0.5), CapProfile::conic(1.8).width(0.5));
    EXPECT_DOUBLE_EQ(CapProfile::conic(-7).width(0.5), CapProfile::conic(-1).width(0.5));
}

// A sphere of radius 1 cut at height h above its lowest point: width^2 is proportional to z (2 - z).
TEST(CapProfile, of_a_sphere_is_exact) {
    for (const double h : {0.1, 0.5, 0.9}) {
        const double radius = std::sqrt(h * (2 - h)), slope_of_radius = (1 - h) / radius;
        const CapProfile cap = CapProfile::conic(slope_of_radius * h / radius);
        for (double x = 0; x <= 1; x += 0.125)
            EXPECT_NEAR(cap.width(x) * radius, std::sqrt(x * h * (2 - x * h)), 1e-12);
    }
}

TEST(CapProfile, of_a_name_is_that_of_the_homotopy) {
    EXPECT_DOUBLE_EQ(CapProfile::of(HomotopyKind::Linear)->width(0.25), 0.25);
    EXPECT_DOUBLE_EQ(CapProfile::of(HomotopyKind::Parabola)->width(0.25), 1 - 0.75 * 0.75);
    EXPECT_DOUBLE_EQ(CapProfile::of(HomotopyKind::Quadrant)->width(0.25), std::sqrt(1 - 0.75 * 0.75));
    EXPECT_FALSE(CapProfile::of(HomotopyKind::Cardinal));
}

}  // namespace
}  // namespace stratareeb
