// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stack_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;
using testing::rectangle;

TEST(StackLevel, rings_know_what_is_on_their_sides) {
    const std::vector<StackContour> contours{rectangle(5, 0, 0, 10, 10), rectangle(5, 1, 1, 9, 9),
                                             rectangle(5, 4, 4, 6, 6), rectangle(5, 20, 0, 21, 1)};
    const StackLevel level(contours);
    EXPECT_EQ(level.z(), 5);
    EXPECT_FALSE(level.is_hole(0) || level.is_hole(2) || level.is_hole(3));
    EXPECT_TRUE(level.is_hole(1));
    EXPECT_EQ(level.parent(0), StackLevel::kOutside);
    EXPECT_EQ(level.parent(2), 1u);
    EXPECT_EQ(level.solid_side(1), 0u);
    EXPECT_EQ(level.void_side(1), 1u);
    EXPECT_EQ(level.solid_side(2), 2u);
    EXPECT_EQ(level.void_side(2), 1u);
}

TEST(StackLevel, places_are_solid_between_an_odd_and_an_even_ring) {
    std::vector<StackContour> contours;
    for (const double radius : {1.0, 2.0, 3.0, 4.0}) contours.push_back(circle(0, 100, -50, radius, 1000));
    const StackLevel level(contours);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-5, 5);
    for (int i = 0; i < 2000; ++i) {
        const double x = unit(random), y = unit(random), r = std::hypot(x, y);
        if (std::abs(r - std::round(r)) < 1e-3) continue;
        EXPECT_EQ(level.is_solid({100 + x, -50 + y}), (r > 1 && r < 2) || (r > 3 && r < 4)) << x << ' ' << y;
    }
}

TEST(StackLevel, line_through_corners_passes_each_once) {
    const std::vector<StackContour> diamond{{.z = 0, .points = {{0, 1}, {1, 0}, {2, 1}, {1, 2}}, .name = {}}};
    const StackLevel level(diamond);
    EXPECT_EQ(level.passages(1).size(), 2u);
    EXPECT_EQ(level.passages(0).size(), 0u) << "the lower end is not part of an edge";
    EXPECT_EQ(level.passages(2).size(), 2u);
    EXPECT_TRUE(level.is_solid({1, 1}));
    EXPECT_FALSE(level.is_solid({-1, 1}));
    EXPECT_FALSE(level.is_solid({3, 1}));
}

}  // namespace
}  // namespace stratareeb
