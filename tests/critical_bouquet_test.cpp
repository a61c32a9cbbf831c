// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_bouquet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace stratareeb {
namespace {

//! Point 0 is the critical point, at zero.
struct Case {
    std::vector<Point3> points{{0, 0, 0}};
    std::vector<PointLoop> contours;
    std::vector<bool> is_hole;

    //! A triangle at the critical point that fills the directions between two angles (degrees), counter-clockwise.
    void add_petal(double from, double to, bool hole, double size = 1) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const double degrees : {from, to}) {
            const double angle = degrees * std::numbers::pi / 180;
            points.push_back({size * std::cos(angle), size * std::sin(angle), 0});
        }
        contours.push_back({0, first, first + 1});
        is_hole.push_back(hole);
    }
    auto across() const { return contours_across(contours, is_hole, {0}, points); }
};

//! The same curve from its least rotation.
PointLoop turned(PointLoop loop) {
    PointLoop least = loop;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        std::ranges::rotate(loop, loop.begin() + 1);
        least = std::min(least, loop);
    }
    return least;
}

TEST(CriticalBouquet, joins_contours_side_by_side_counter_clockwise) {
    Case c;
    c.add_petal(-20, 20, false);
    c.add_petal(220, 250, false);
    c.add_petal(100, 140, false);
    const auto across = c.across();
    ASSERT_TRUE(across);
    ASSERT_EQ(across->size(), 1u);
    EXPECT_EQ(turned(across->front()), (PointLoop{0, 1, 2, 0, 5, 6, 0, 3, 4}));
}

TEST(CriticalBouquet, opens_a_ring_where_its_hole_touches_its_rim) {
    Case c;
    c.add_petal(-60, 60, false, 10);
    c.add_petal(-10, 10, true, 1);
    const auto across = c.across();
    ASSERT_TRUE(across);
    ASSERT_EQ(across->size(), 1u);
    EXPECT_EQ(turned(across->front()), (PointLoop{0, 1, 2, 0, 4, 3})) << "the hole runs the other way";
}

TEST(CriticalBouquet, parts_a_contour_that_passes_twice) {
    Case c;
    c.points = {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
    c.contours = {{0, 1, 2, 0, 3, 4}};
    c.is_hole = {false};
    const auto across = c.across();
    ASSERT_TRUE(across);
    ASSERT_EQ(across->size(), 2u);
    EXPECT_EQ(turned((*across)[0]), (PointLoop{0, 1, 2}));
    EXPECT_EQ(turned((*across)[1]), (PointLoop{0, 3, 4}));
}

// There and back again, for any number of petals, nested or not.
TEST(CriticalBouquet, seen_from_the_far_side_is_what_it_was) {
    std::mt19937_64 random(51);
    for (int round = 0; round < 500; ++round) {
        Case c;
        const int petals = 2 + static_cast<int>(random() % 5);
        for (int k = 0; k < petals; ++k) {
            const double from = 360.0 * k / petals, width = 300.0 / petals;
            c.add_petal(from, from + width, false, 5);
        }
        std::ranges::shuffle(c.contours, random);
        const auto across = c.across();
        ASSERT_TRUE(across);
        ASSERT_EQ(across->size(), 1u);
        const auto back = contours_across(*across, {false}, {0}, c.points);
        ASSERT_TRUE(back);
        std::vector<PointLoop> expected, found;
        for (const auto& loop : c.contours) expected.push_back(turned(loop));
        for (const auto& loop : *back) found.push_back(turned(loop));
        std::ranges::sort(expected);
        std::ranges::sort(found);
        EXPECT_EQ(found, expected);
    }
}

// Three squares in a row that touch at two points of one height.
TEST(CriticalBouquet, joins_a_chain_of_contours) {
    Case c;
    c.points = {{0, 0, 0}, {4, 0, 0}, {-2, -1, 0}, {-2, 1, 0}, {2, -1, 0}, {2, 1, 0}, {6, -1, 0}, {6, 1, 0}};
    c.contours = {{0, 3, 2}, {0, 4, 1, 5}, {6, 7, 1}};
    c.is_hole = {false, false, false};
    const auto across = contours_across(c.contours, c.is_hole, {0, 1}, c.points);
    ASSERT_TRUE(across);
    ASSERT_EQ(across->size(), 1u);
    EXPECT_EQ(turned(across->front()), (PointLoop{0, 3, 2, 0, 4, 1, 6, 7, 1, 5}));
}

TEST(CriticalBouquet, has_no_answer_where_contours_cross) {
    Case c;
    c.add_petal(0, 90, false);
    c.add_petal(45, 135, false);
    EXPECT_FALSE(c.across());
}

}  // namespace
}  // namespace stratareeb
