// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/refined_contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reeb/contours_between.h"

namespace stratareeb {
namespace {

LevelContour circle(double z, double radius) {
    LevelContour contour{z, {}};
    for (int i = 0; i < 64; ++i) {
        const double angle = std::numbers::pi * i / 32;
        contour.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return contour;
}

std::vector<LevelContour> refined(const std::function<LevelContour(double)>& at,
                                  const ContourRefinement& options) {
    std::vector<LevelContour> contours{at(0.5), at(9.5)};
    refine_contours(contours, HeightScale(0, 10, false, false), at, options);
    return contours;
}

double widest_gap(const std::vector<LevelContour>& contours) {
    double gap = 0;
    for (std::size_t k = 1; k < contours.size(); ++k) gap = std::max(gap, contours[k].z - contours[k - 1].z);
    return gap;
}

LevelContour vase(double z) {
    return circle(z, 2 + std::sin(z));
}

TEST(RefinedContours, stay_as_they_are_where_nothing_crosses_and_no_tolerance_is_asked) {
    EXPECT_EQ(refined(vase, {}).size(), 2u);
    EXPECT_EQ(refined([](double z) { return circle(z, 1 + z); }, {.tolerance = 1e-3}).size(), 2u) << "a cone";
}

// At a step no contour between is near enough: they stop where closer ones would be rounding, not at the last bit.
TEST(RefinedContours, leave_room_between_one_another_at_a_step) {
    const auto step = [](double z) { return circle(z, z < 5.123 ? 1 : 2); };
    const auto contours = refined(step, {.tolerance = 0.01});
    EXPECT_GT(contours.size(), 10u);
    double least = 10;
    for (std::size_t k = 1; k < contours.size(); ++k)
        least = std::min(least, contours[k].z - contours[k - 1].z);
    EXPECT_GT(least, 0.49e-4 * 9);
    EXPECT_TRUE(has_room(1, 1.5, 0, 10));
    EXPECT_FALSE(has_room(1, 1.0009, 0, 10));
    EXPECT_FALSE(has_room(1e9, 1e9 + 1e-4, 1e9, 1e9 + 1e-3));
}

TEST(RefinedContours, come_as_near_as_is_asked_half_way) {
    std::size_t before = 0;
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        const auto contours = refined(vase, {.tolerance = tolerance});
        EXPECT_GT(contours.size(), before);
        before = contours.size();
        const HeightScale scale(0, 10, false, false);
        for (std::size_t k = 0; k + 1 < contours.size(); ++k) {
            const double z = (contours[k].z + contours[k + 1].z) / 2;
            ASSERT_LT(contours[k].z, contours[k + 1].z);
            EXPECT_LE(plan_deviation(vase(z).points,
                                     contour_between(contours, k, z, scale, HomotopyKind::Cardinal)),
                      tolerance);
        }
    }
}

TEST(RefinedContours, share_their_room_evenly) {
    const auto contours = refined(vase, {.tolerance = 1e-12, .most = 17});
    EXPECT_EQ(contours.size(), 17u);
    EXPECT_NEAR(widest_gap(contours), 9.0 / 16, 1e-12);
}

//! Each contour is turned against all others by half a turn of a long bar, so that what is between any two crosses itself.
TEST(RefinedContours, that_cross_whatever_is_between_do_not_crowd_without_end) {
    std::size_t asked = 0;
    const auto bars = [&](double z) {
        LevelContour contour{z, {}};
        const double turn = 2.4 * static_cast<double>(asked++);
        for (const auto& [x, y] :
             std::vector<std::pair<double, double>>{{-9, -1}, {9, -1}, {9, 1}, {0, 0.2}, {-9, 1}})
            contour.points.push_back(
                {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), z});
        return contour;
    };
    EXPECT_LE(refined(bars, {}).size(), 17u);
}

}  // namespace
}  // namespace stratareeb
