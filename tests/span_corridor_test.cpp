// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/span_corridor.h"

#include <gtest/gtest.h>

#include "reeb/coarse_to_fine.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

//! Whatever the known cost: paths that cost less stay possible, start by start.
void expect_room_for_cheap_paths(const SpanContours& c, double share) {
    const SpanPath known = coarse_to_fine_cycle(c);
    const auto m = static_cast<std::uint32_t>(c.upper.size());
    const std::uint32_t first_upper = (known.upper + m - m / 2) % m;
    const SpanCosts costs(c, first_upper, known.lower);
    const StepBounds bounds = step_bounds(c, first_upper, known.lower, known);
    const StartPrices prices = start_prices(costs, bounds, known, 0.1 * known.cost);
    for (std::size_t start = 0; start < prices.price.size(); ++start)
        EXPECT_LE(std::abs(prices.price[start] - bounds.upper[start]), prices.deviation * (1 + 1e-9));
    SpanCorridor corridor(costs, bounds, prices);
    const Corridor all = corridor.corridor();
    StairPathFinder finder(costs, m);
    const double limit = known.cost * share;
    for (int round = 0; round < 2; ++round) {
        corridor.narrow(limit);
        EXPECT_LE(corridor.corridor().spans(), all.spans());
        for (std::int32_t start = 0; start < static_cast<std::int32_t>(m); ++start) {
            const auto path = finder.shortest(start, all);
            ASSERT_TRUE(path);
            if (path->cost > limit) continue;
            EXPECT_TRUE(std::ranges::binary_search(corridor.starts(), start));
            const auto inside = finder.shortest(start, corridor.corridor());
            ASSERT_TRUE(inside);
            EXPECT_EQ(inside->cost, path->cost);
        }
    }
}

TEST(SpanCorridor, keeps_every_path_that_is_as_cheap_as_the_known_one) {
    std::mt19937 random(1);
    for (std::size_t run = 0; run < 60; ++run) {
        const std::size_t m = 5 + run, n = 10 + 3 * (run % 20);
        const Points upper = wobbly_circle(m, 1, 0.3, 0.1, 0.02, random),
                     lower = wobbly_circle(n, 1, 0, 0.1, 0.02, random);
        const Points some = grid_points(m, 4, random), others = grid_points(n, 4, random);
        for (const BandCost cost : {BandCost::Area, BandCost::SpanLength})
            for (const double share : {1.0, 1.02, 1.3}) {
                ASSERT_NO_FATAL_FAILURE(
                    expect_room_for_cheap_paths({.upper = upper, .lower = lower, .cost = cost}, share));
                ASSERT_NO_FATAL_FAILURE(
                    expect_room_for_cheap_paths({.upper = some, .lower = others, .cost = cost}, share));
            }
    }
}

TEST(SpanCorridor, is_narrow_between_noisy_circles) {
    std::mt19937 random(2);
    const Points upper = wobbly_circle(600, 1, 0.1, 0.02, 0.0005, random),
                 lower = wobbly_circle(700, 1, 0, 0.02, 0.0005, random);
    const SpanContours c{.upper = upper, .lower = lower};
    const SpanPath known = coarse_to_fine_cycle(c);
    const std::uint32_t first_upper = (known.upper + 300) % 600;
    const SpanCosts costs(c, first_upper, known.lower);
    const StepBounds bounds = step_bounds(c, first_upper, known.lower, known);
    const StartPrices prices =
        start_prices(costs, bounds, known, 0.1 * (known.cost - bounds.upper[600] - bounds.lower[700]));
    SpanCorridor corridor(costs, bounds, prices);
    corridor.narrow(known.cost);
    EXPECT_FALSE(corridor.starts().empty());
    EXPECT_LT(corridor.corridor().spans(), 600 * 700 / 4);
    EXPECT_LT(corridor.looked_at(), 600 * 700);
}

}  // namespace
}  // namespace stratareeb
