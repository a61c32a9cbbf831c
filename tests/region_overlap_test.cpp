// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/region_overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;
using testing::rectangle;
using Rings = std::vector<std::uint32_t>;

const std::vector<StackContour> kRing{rectangle(0, 0, 0, 10, 10), rectangle(0, 3, 3, 7, 7)};

TEST(RegionOverlap, areas_of_two_rings_that_cross_are_exact) {
    // Squares with holes, one moved by (2, 1): by hand from rectangles.
    const std::vector<StackContour> moved{rectangle(1, 2, 1, 12, 11), rectangle(1, 5, 4, 9, 8)};
    const Rings both{0, 1};
    const RegionOverlaps overlaps = region_overlaps(StackLevel(kRing), both, StackLevel(moved), both);
    const double squares = 8 * 9, holes = 2 * 3, hole_in_square = 16;
    EXPECT_NEAR(overlaps.at({1, 1}), holes, 1e-9);
    EXPECT_NEAR(overlaps.at({0, 1}), hole_in_square - holes, 1e-9);
    EXPECT_NEAR(overlaps.at({1, 0}), hole_in_square - holes, 1e-9);
    EXPECT_NEAR(overlaps.at({0, 0}), squares - holes - 2 * (hole_in_square - holes), 1e-9);
    EXPECT_TRUE(std::isinf(overlaps.at({StackLevel::kOutside, StackLevel::kOutside})));
}

TEST(RegionOverlap, circles_converge_to_the_lens) {
    const std::vector<StackContour> a{circle(0, 0, 0, 1, 20000)}, b{circle(1, 1, 0, 1, 20000)};
    const Rings one{0};
    const double lens = 2 * std::numbers::pi / 3 - std::sqrt(3) / 2;
    EXPECT_NEAR(region_overlaps(StackLevel(a), one, StackLevel(b), one).at({0, 0}), lens, 1e-6);
}

}  // namespace
}  // namespace stratareeb
