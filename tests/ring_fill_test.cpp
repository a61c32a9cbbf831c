// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ring_fill.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

double area_of(const std::vector<Point2>& corners, const Rings& rings) {
    double sum = 0;
    for (const auto& [a, b, c] : ring_fill(corners, rings)) {
        const Point2 &p = corners[a], &q = corners[b], &r = corners[c];
        const double twice = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        EXPECT_GT(twice, 0);
        sum += twice / 2;
    }
    return sum;
}

//! The corners of a square from (0, 0) to (4, 4), of one from (1, 1) to (3, 3), and of one from (4, 0) to (6, 4).
const std::vector<Point2> kCorners{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1},
                                   {3, 1}, {3, 3}, {1, 3}, {6, 0}, {6, 4}};
const std::vector<std::uint32_t> kOuter{0, 1, 2, 3}, kInner{4, 5, 6, 7}, kBeside{1, 8, 9, 2};

TEST(RingFill, fills_what_an_odd_number_of_rings_lies_around) {
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kOuter}), 16);
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kOuter, kInner}), 12);
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kInner, kOuter, kInner}), 16);
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kOuter, {7, 6, 5, 4}}), 12) << "whichever way they run";
    EXPECT_DOUBLE_EQ(area_of(kCorners, {}), 0);
}

TEST(RingFill, rings_may_share_sides_and_corners) {
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kOuter, kBeside}), 24) << "the common side is no border";
    EXPECT_DOUBLE_EQ(area_of(kCorners, {kOuter, kOuter}), 0);
    EXPECT_DOUBLE_EQ(area_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {kOuter, {0, 1, 2}}), 8) << "a part in common";
    EXPECT_DOUBLE_EQ(area_of({{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {{0, 1, 2, 0, 3, 4}}), 2)
        << "a bow tie";
}

TEST(RingFill, names_where_sides_cross) {
    EXPECT_THROW(ring_fill(kCorners, Rings{{0, 2, 1, 3}}), InvalidInput);
    EXPECT_THROW(
        ring_fill(std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {3, -1}}, Rings{{0, 1, 2}, {3, 4, 2}}),
        InvalidInput)
        << "a corner on a side";
    EXPECT_THROW(ring_fill(std::vector<Point2>{{0, 0}, {1, 0}, {0, 0}}, Rings{{0, 1, 2}}), InvalidInput);
    EXPECT_THROW(ring_fill(kCorners, Rings{{0, 0, 1, 2}}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
