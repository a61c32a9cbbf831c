// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Ring = std::vector<Point2>;

Ring square(double x, double y, double side, bool clockwise = false) {
    Ring ring{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
    if (clockwise) std::reverse(ring.begin() + 1, ring.end());
    return ring;
}

double ring_area(const Ring& ring) {
    return area(Footprint{ring});
}

std::string refusal(const Footprint& footprint) {
    try {
        checked_footprint(footprint);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

std::vector<Point2> random_places(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(0, 1000);
    std::vector<Point2> at(count);
    for (Point2& p : at) p = {anywhere(random), anywhere(random)};
    return at;
}

TEST(Footprint, area_is_that_of_outer_rings_less_that_of_holes) {
    EXPECT_DOUBLE_EQ(area({square(0, 0, 10)}), 100);
    EXPECT_DOUBLE_EQ(area({square(0, 0, 10), square(2, 3, 4, true)}), 84);
    EXPECT_DOUBLE_EQ(area({square(0, 0, 10), square(20, 0, 3)}), 109);
    Ring circle;
    constexpr int kCorners = 1000;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        circle.push_back({5e6 + 7 * std::cos(angle), 4.9e6 + 7 * std::sin(angle)});
    }
    const double exact = kCorners * 49 / 2.0 * std::sin(2 * std::numbers::pi / kCorners);
    EXPECT_NEAR(area({circle}), exact, 1e-6);
}

TEST(Footprint, hull_holds_all_holes_and_is_convex) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto holes = random_places(seed, 4 + 5 * seed);
        const Footprint hull = hull_footprint(HoleTriangulation(holes));
        ASSERT_EQ(hull.size(), 1u);
        const Ring& ring = hull[0];
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            EXPECT_NE(std::ranges::find(holes, a), holes.end());
            for (const Point2& p : holes)
                EXPECT_GE((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x), -1e-3) << "seed " << seed;
        }
        EXPECT_GT(area(hull), 0);
    }
}

TEST(Footprint, hull_of_holes_in_a_line_is_refused_with_the_way_out) {
    for (const std::vector<Point2>& holes : {std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}},
                                             {{0, 0}, {5, 0}},
                                             {{3, 3}},
                                             {{0, 0}, {1000, 0}, {500, 0.01}}})
        try {
            hull_footprint(HoleTriangulation(holes));
            FAIL() << holes.size() << " holes";
        } catch (const InvalidInput& error) {
            EXPECT_NE(std::string(error.what()).find("--footprint box"), std::string::npos) << error.what();
        }
}

TEST(Footprint, box_stands_around_the_holes_by_the_margin) {
    EXPECT_EQ(box_footprint({{1, 2}, {4, 3}, {2, 9}}, 0.5),
              (Footprint{{{0.5, 1.5}, {4.5, 1.5}, {4.5, 9.5}, {0.5, 9.5}}}));
    EXPECT_DOUBLE_EQ(area(box_footprint({{5e6, 5e6}}, 2)), 16) << "one hole";
}

TEST(Footprint, box_without_area_is_refused) {
    EXPECT_THROW(box_footprint({{3, 3}}, 0), InvalidInput);
    EXPECT_THROW(box_footprint({{0, 3}, {9, 3}}, 0), InvalidInput);
    EXPECT_THROW(box_footprint({{0, 0}, {9, 9}}, -5), InvalidInput);
}

TEST(Footprint, suitable_margin_is_half_the_mean_spacing_or_a_tenth_of_a_line) {
    EXPECT_DOUBLE_EQ(suitable_margin(HoleTriangulation({{0, 0}, {10, 0}, {10, 10}, {0, 10}})), 2.5);
    EXPECT_DOUBLE_EQ(suitable_margin(HoleTriangulation({{0, 0}, {3, 4}, {6, 8}})), 1);
}

TEST(Footprint, is_inside_follows_the_even_odd_rule) {
    const Footprint ring_with_island{square(0, 0, 10), square(2, 2, 6, true), square(4, 4, 2)};
    EXPECT_TRUE(is_inside(ring_with_island, {1, 5}));
    EXPECT_FALSE(is_inside(ring_with_island, {3, 5}));
    EXPECT_TRUE(is_inside(ring_with_island, {5, 5}));
    EXPECT_FALSE(is_inside(ring_with_island, {11, 5}));
    EXPECT_FALSE(is_inside(ring_with_island, {-1, 2})) << "level with corners";
    EXPECT_TRUE(is_inside(ring_with_island, {1, 2})) << "level with corners";
}

TEST(CheckedFootprint, turns_rings_drops_repeats_and_keeps_the_shape) {
    Ring outer = square(0, 0, 10, true), hole = square(2, 2, 3), apart = square(20, 20, 1, true);
    outer.insert(outer.begin() + 1, outer[0]);
    outer.push_back(outer.front());
    const Footprint found = checked_footprint({outer, hole, apart});
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].size(), 4u);
    EXPECT_DOUBLE_EQ(ring_area(found[0]), 100);
    EXPECT_DOUBLE_EQ(ring_area(found[1]), -9);
    EXPECT_DOUBLE_EQ(ring_area(found[2]), 1);
    EXPECT_DOUBLE_EQ(area(found), 92);
}

TEST(CheckedFootprint, an_island_in_a_hole_is_an_outer_ring) {
    const Footprint found = checked_footprint({square(4, 4, 2, true), square(0, 0, 10), square(2, 2, 6)});
    EXPECT_DOUBLE_EQ(area(found), 100 - 36 + 4);
}

TEST(CheckedFootprint, takes_corners_in_the_middle_of_straight_sides) {
    EXPECT_DOUBLE_EQ(area(checked_footprint({{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 4}}})), 100);
}

TEST(CheckedFootprint, refuses_nothing_and_rings_without_area) {
    EXPECT_NE(refusal({}).find("no outline"), std::string::npos);
    EXPECT_NE(refusal({Ring{}}).find("fewer than three corners"), std::string::npos);
    EXPECT_NE(refusal({{{0, 0}, {1, 0}, {1, 0}, {0, 0}}}).find("fewer than three corners"),
              std::string::npos);
    EXPECT_NE(refusal({{{0, 0}, {1, 1}, {2, 2}}}), "");
    EXPECT_NE(refusal({{{0, 0}, {5, 0}, {5, 5}, {5, 0}}}), "") << "a spike";
}

TEST(CheckedFootprint, refuses_rings_that_cross_and_names_the_place) {
    const Ring bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
    EXPECT_NE(refusal({bow}), "") << "crosses itself, no area";
    const Ring lopsided{{0, 0}, {100, 100}, {100, 40}, {0, 60}};
    EXPECT_NE(refusal({lopsided}).find("crosses or touches itself near x "), std::string::npos)
        << refusal({lopsided});
    const std::string two = refusal({square(7000, 0, 10), square(7005, 5, 10)});
    EXPECT_NE(two.find("crosses or touches itself near x 70"), std::string::npos) << two;
}

TEST(CheckedFootprint, refuses_rings_that_touch) {
    EXPECT_NE(refusal({square(0, 0, 10), square(10, 10, 5)}), "") << "in a corner";
    EXPECT_NE(refusal({square(0, 0, 10), square(10, 2, 5)}), "") << "along a side";
    EXPECT_NE(refusal({square(0, 0, 10), square(0, 0, 10)}), "") << "everywhere";
    EXPECT_NE(refusal({{{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}}), "") << "itself, corner on side";
}

TEST(WithPointsOnRings, makes_corners_of_near_points_and_leaves_the_others) {
    const Footprint found = with_points_on_rings(
        {square(0, 0, 10)}, {{3, 1e-10}, {7, 0}, {5, 1}, {10, 5}, {0, 0}, {5, 10.5}, {-3, 0}}, 1e-9);
    EXPECT_EQ(found, (Footprint{{{0, 0}, {3, 1e-10}, {7, 0}, {10, 0}, {10, 5}, {10, 10}, {0, 10}}}));
}

TEST(WithPointsOnRings, takes_a_place_given_twice_once) {
    EXPECT_EQ(with_points_on_rings({square(0, 0, 4)}, {{2, 0}, {2, 0}}, 1e-9)[0].size(), 5u);
}

TEST(WithPointsOnRings, keeps_the_order_on_both_windings) {
    const Footprint found = with_points_on_rings({square(0, 0, 8), square(2, 2, 4, true)},
                                                 {{4, 2}, {3, 2}, {5, 2}, {2, 4}}, 1e-9);
    EXPECT_EQ(found[1], (Ring{{2, 2}, {2, 4}, {2, 6}, {6, 6}, {6, 2}, {5, 2}, {4, 2}, {3, 2}}));
}

}  // namespace
}  // namespace stratareeb
