// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/coarse_to_fine.h"

#include <gtest/gtest.h>

#include "reeb/shortest_cycle.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

TEST(CoarseToFine, is_a_cycle_little_dearer_than_the_cheapest) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> size(2, 300);
    for (int run = 0; run < 200; ++run) {
        const double noise = run % 3 == 0 ? 0.02 : 0;  // at 300 points as large as their distance
        const Problem p{.upper = wobbly_circle(size(random), 1, 0.3, 0.05, noise, random),
                        .lower = wobbly_circle(size(random), 1, 0, 0.05, noise, random)};
        const SpanContours contours{.upper = p.upper, .lower = p.lower};
        const SpanPath path = coarse_to_fine_cycle(contours);
        ASSERT_EQ(path.upper_advances.size(), p.upper.size() + p.lower.size());
        EXPECT_EQ(std::ranges::count(path.upper_advances, 1), static_cast<std::ptrdiff_t>(p.upper.size()));
        EXPECT_NEAR(path.cost, cost_along(p, path), 1e-12 * path.cost);
        EXPECT_LE(path.cost, 1.2 * shortest_cycle(contours).cost) << p.upper.size() << " " << p.lower.size();
    }
}

}  // namespace
}  // namespace stratareeb
