// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/ring_gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;
using testing::rectangle;
using Rings = std::vector<std::vector<Point2>>;

TEST(RingGap, middle_of_the_shortest_line) {
    const auto anywhere = [](const Point2&) { return true; };
    const Rings two{rectangle(0, 0, 0, 2, 2).points, rectangle(0, 5, 1, 7, 9).points};
    const Point2 p = ring_gap(two, anywhere);
    EXPECT_DOUBLE_EQ(p.x, 3.5);
    EXPECT_GE(p.y, 1);
    EXPECT_LE(p.y, 2);
    const auto above = [](const Point2& q) { return q.y > 1.7; };
    EXPECT_GT(ring_gap(two, above).y, 1.7);
    const auto nowhere = [](const Point2&) { return false; };
    EXPECT_DOUBLE_EQ(ring_gap(two, nowhere).x, 3.5);
}

TEST(RingGap, several_rings_meet_in_their_midst_if_that_is_allowed) {
    Rings three;
    for (int k = 0; k < 3; ++k)
        three.push_back(circle(0, 4 * std::cos(2.0944 * k), 4 * std::sin(2.0944 * k), 3).points);
    const Point2 p = ring_gap(three, [&](const Point2& q) { return std::hypot(q.x, q.y) < 2; });
    EXPECT_LT(std::hypot(p.x, p.y), 2);
    const Rings row{rectangle(0, 0, 0, 2, 2).points, rectangle(0, 3, 0, 5, 2).points,
                    rectangle(0, 6, 0, 8, 2).points};
    const Point2 q = ring_gap(row, [](const Point2& at) { return at.x < 3 || at.x > 5; });
    EXPECT_TRUE(q.x == 2.5 || q.x == 5.5);
}

}  // namespace
}  // namespace stratareeb
