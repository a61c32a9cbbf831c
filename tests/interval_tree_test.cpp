// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/interval_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace stratareeb {
namespace {

TEST(IntervalTree, finds_what_looking_at_each_interval_finds) {
    std::mt19937_64 random(5);
    for (int round = 0; round < 300; ++round) {
        const double range = round % 2 ? 6 : 1000;  // many equal ends, or few
        const auto number = [&] { return static_cast<double>(random() % static_cast<int>(range)); };
        std::vector<IntervalTree::Interval> intervals(random() % 40);
        for (auto& interval : intervals) interval = {number(), number()};  // empty ones too
        const IntervalTree tree(intervals);
        for (double x = -1; x <= range; x += range / 24) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < intervals.size(); ++i)
                if (intervals[i].low < x && x <= intervals[i].high) expected.push_back(i);
            ASSERT_EQ(tree.holding(x), expected);
        }
    }
}

TEST(IntervalTree, stays_shallow_with_equal_intervals) {
    const std::vector<IntervalTree::Interval> intervals(100'000, {0, 1});
    EXPECT_EQ(IntervalTree(intervals).holding(0.5).size(), intervals.size());
    EXPECT_TRUE(IntervalTree(intervals).holding(0).empty());
    EXPECT_EQ(IntervalTree(intervals).holding(1).size(), intervals.size());
}

}  // namespace
}  // namespace stratareeb
