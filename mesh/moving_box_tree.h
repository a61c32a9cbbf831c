// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace stratareeb {

struct AxisBox {
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};  // holds nothing

    void include(const AxisBox& other) {
        for (int k = 0; k < 3; ++k)
            low[k] = std::min(low[k], other.low[k]), high[k] = std::max(high[k], other.high[k]);
    }
    bool meets(const AxisBox& other) const {
        for (int k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
    friend bool operator==(const AxisBox&, const AxisBox&) = default;
};

//! Boxes that grow, shrink and vanish while they are asked for what meets a place. The tree's shape is that of the boxes at
//! the start: it stays good while boxes stay near where they were.
class MovingBoxTree {
 public:
    explicit MovingBoxTree(std::vector<AxisBox> boxes) : boxes_(std::move(boxes)), leaf_of_(boxes_.size()) {
        while (leaves_ < boxes_.size()) leaves_ *= 2;
        nodes_.resize(2 * leaves_);
        item_.assign(leaves_, 0);
        std::vector<std::uint32_t> order(boxes_.size());
        std::iota(order.begin(), order.end(), 0u);
        place(order.begin(), order.end(), 1, leaves_);
        for (std::size_t n = leaves_; n-- > 1;) nodes_[n] = joined(n);
    }

    //! An empty box for what has gone.
    void set(std::uint32_t item, const AxisBox& box) {
        boxes_[item] = box;
        std::size_t n = leaf_of_[item];
        nodes_[n] = box;
        for (n /= 2; n > 0; n /= 2) {
            const AxisBox now = joined(n);
            if (now == nodes_[n]) return;
            nodes_[n] = now;
        }
    }

    //! Whether any item whose box meets the one given is found to be what is looked for.
    template <typename Found>
    bool any_of(const AxisBox& box, const Found& found, std::size_t node = 1) const {
        if (!nodes_[node].meets(box)) return false;
        if (node >= leaves_) return found(item_[node - leaves_]);
        return any_of(box, found, 2 * node) || any_of(box, found, 2 * node + 1);
    }

 private:
    using Iterator = std::vector<std::uint32_t>::iterator;

    AxisBox joined(std::size_t n) const {
        AxisBox box = nodes_[2 * n];
        box.include(nodes_[2 * n + 1]);
        return box;
    }

    //! Halves by the middles of boxes along their longest extent.
    void place(Iterator first, Iterator last, std::size_t node, std::size_t leaves) {
        const auto count = static_cast<std::size_t>(last - first);
        if (count == 0) return;
        if (leaves == 1) {
            item_[node - leaves_] = *first;
            leaf_of_[*first] = static_cast<std::uint32_t>(node);
            nodes_[node] = boxes_[*first];
            return;
        }
        const auto middle = [&](std::uint32_t i, int k) { return boxes_[i].low[k] + boxes_[i].high[k]; };
        std::array<double, 3> extent{};
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax_element(first, last, [&](auto a, auto b) { return middle(a, k) < middle(b, k); });
            extent[k] = middle(*high, k) - middle(*low, k);
        }
        const int axis = static_cast<int>(std::max_element(extent.begin(), extent.end()) - extent.begin());
        const Iterator half = first + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(first, half, last, [&](auto a, auto b) {
            return std::pair(middle(a, axis), a) < std::pair(middle(b, axis), b);
        });
        place(first, half, 2 * node, leaves / 2);
        place(half, last, 2 * node + 1, leaves / 2);
    }

    std::vector<AxisBox> boxes_;
    std::vector<std::uint32_t> leaf_of_;
    std::size_t leaves_ = 1;
    std::vector<AxisBox> nodes_;       // 1 is the root, 2 n and 2 n + 1 are below n
    std::vector<std::uint32_t> item_;  // of each leaf
};

}  // namespace stratareeb
