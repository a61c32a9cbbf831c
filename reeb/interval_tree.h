// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stratareeb {

//! Intervals (low, high], asked which of them hold a number: O(log n + found) a question, O(n log n) to build
//! (H. Edelsbrunner 1980). Empty intervals hold nothing.
class IntervalTree {
 public:
    struct Interval {
        double low = 0, high = 0;
    };

    explicit IntervalTree(std::span<const Interval> intervals);

    //! Indices of the intervals with low < x <= high, ascending.
    std::vector<std::uint32_t> holding(double x) const;

 private:
    static constexpr std::uint32_t kNone = ~0u;

    struct Node {
        double center = 0;  // in each of the node's own intervals
        std::size_t begin = 0, end = 0;
        std::uint32_t left = kNone, right = kNone;
    };

    std::uint32_t build(std::vector<std::uint32_t> members);

    std::vector<Interval> intervals_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> by_low_, by_high_;  // each node's own: lows ascending, highs descending
};

}  // namespace stratareeb
