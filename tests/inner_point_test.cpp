// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/inner_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;
using testing::rectangle;
using Rings = std::vector<std::vector<Point2>>;

TEST(InnerPoint, center_of_a_square_and_middle_of_a_strip) {
    const Point2 p = inner_point(Rings{rectangle(0, 2, 3, 6, 7).points});
    EXPECT_NEAR(p.x, 4, 0.2);
    EXPECT_NEAR(p.y, 5, 0.2);
    const Point2 q = inner_point(Rings{rectangle(0, 0, 0, 1000, 1).points});
    EXPECT_NEAR(q.y, 0.5, 0.05);
}

TEST(InnerPoint, lies_in_the_wall_of_a_c_and_of_a_ring) {
    const Point2 p = inner_point(Rings{testing::c_shape(0, 3, 5, 0.4).points});
    EXPECT_NEAR(std::hypot(p.x, p.y), 4, 0.15);
    const Point2 q = inner_point(Rings{circle(0, 0, 0, 5).points, circle(0, 0, 0, 3).points});
    EXPECT_NEAR(std::hypot(q.x, q.y), 4, 0.15);
}

TEST(InnerPoint, thin_slivers_far_from_the_origin) {
    for (const double width : {1e-1, 1e-3, 1e-5}) {
        const Rings sliver{{{500000, 5000000}, {500100, 5000100}, {500100 + width, 5000100}}};
        const Point2 p = inner_point(sliver);
        const double share = (p.y - 5000000) / 100;  // up the sliver
        EXPECT_GT(p.x - 500000, 100 * share) << width;
        EXPECT_LT(p.x - 500000, (100 + width) * share) << width;
    }
}

}  // namespace
}  // namespace stratareeb
