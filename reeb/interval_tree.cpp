// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/interval_tree.h"

#include <algorithm>

namespace stratareeb {

IntervalTree::IntervalTree(std::span<const Interval> intervals)
    : intervals_(intervals.begin(), intervals.end()) {
    std::vector<std::uint32_t> members;
    for (std::uint32_t i = 0; i < intervals_.size(); ++i)
        if (intervals_[i].low < intervals_[i].high) members.push_back(i);
    build(std::move(members));
}

//! The median of the upper ends parts the intervals into those below it, those above and those that hold it.
std::uint32_t IntervalTree::build(std::vector<std::uint32_t> members) {
    if (members.empty()) return kNone;
    const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
    std::ranges::nth_element(members, middle, {}, [&](std::uint32_t i) { return intervals_[i].high; });
    const double center = intervals_[*middle].high;
    std::vector<std::uint32_t> left, right, here;
    for (const std::uint32_t i : members)
        (intervals_[i].high < center ? left : intervals_[i].low >= center ? right : here).push_back(i);
    members = {};

    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({center, by_low_.size(), by_low_.size() + here.size(), kNone, kNone});
    std::ranges::sort(here, {}, [&](std::uint32_t i) { return std::pair(intervals_[i].low, i); });
    by_low_.insert(by_low_.end(), here.begin(), here.end());
    std::ranges::sort(here, {}, [&](std::uint32_t i) { return std::pair(-intervals_[i].high, i); });
    by_high_.insert(by_high_.end(), here.begin(), here.end());
    const std::uint32_t below = build(std::move(left)), above = build(std::move(right));
    nodes_[node].left = below;
    nodes_[node].right = above;
    return node;
}

std::vector<std::uint32_t> IntervalTree::holding(double x) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = nodes_.empty() ? kNone : 0; n != kNone;) {
        const Node& node = nodes_[n];
        const bool is_below = x <= node.center;
        for (std::size_t k = node.begin; k < node.end; ++k) {
            const std::uint32_t i = is_below ? by_low_[k] : by_high_[k];
            if (is_below ? !(intervals_[i].low < x) : intervals_[i].high < x) break;
            found.push_back(i);
        }
        n = is_below ? node.left : node.right;
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace stratareeb
