// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_order.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace stratareeb {

namespace {

constexpr unsigned kDigitBits = 11, kPasses = 3;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kBlock = std::size_t{1} << 18;  // elements that one thread counts and moves on its own

struct Item {
    std::uint32_t key, index;
};

using Histogram = std::array<std::uint32_t, kDigits>;

std::size_t block_count(std::size_t n) {
    return (n + kBlock - 1) / kBlock;
}

template <class Work>
void for_blocks(std::size_t n, const Work& work) {
    tbb::parallel_for(std::size_t{0}, block_count(n),
                      [&](std::size_t b) { work(b, b * kBlock, std::min(n, (b + 1) * kBlock)); });
}

//! One stable pass by a digit of the key; each block writes to places of its own.
void sort_by_digit(const std::vector<Item>& from, std::vector<Item>& to, unsigned shift) {
    const std::size_t n = from.size();
    std::vector<Histogram> place(block_count(n));
    for_blocks(n, [&](std::size_t b, std::size_t begin, std::size_t end) {
        place[b].fill(0);
        for (std::size_t i = begin; i < end; ++i) ++place[b][from[i].key >> shift & (kDigits - 1)];
    });
    std::uint32_t sum = 0;
    for (std::size_t digit = 0; digit < kDigits; ++digit)
        for (Histogram& block : place) sum += std::exchange(block[digit], sum);
    for_blocks(n, [&](std::size_t b, std::size_t begin, std::size_t end) {
        Histogram& next = place[b];
        for (std::size_t i = begin; i < end; ++i) to[next[from[i].key >> shift & (kDigits - 1)]++] = from[i];
    });
}

//! Items whose keys coincide stand in the order of their indices; put them into that of their values.
void order_equal_keys(std::vector<Item>& items, std::span<const double> values) {
    const auto is_below = [&](const Item& a, const Item& b) {
        return values[a.index] < values[b.index] || (values[a.index] == values[b.index] && a.index < b.index);
    };
    for (auto begin = items.begin(); begin != items.end();) {
        auto end = begin + 1;
        while (end != items.end() && end->key == begin->key) ++end;
        if (end - begin > 1 && !std::is_sorted(begin, end, is_below)) std::sort(begin, end, is_below);
        begin = end;
    }
}

//! Indices in order, by key and then by value. The keys grow with the values: rounding is monotone.
std::vector<Item> sorted_items(std::span<const double> values, double lowest, double scale) {
    std::vector<Item> items(values.size()), other(values.size());
    for_blocks(values.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            items[i] = {static_cast<std::uint32_t>((values[i] - lowest) * scale),
                        static_cast<std::uint32_t>(i)};
    });
    for (unsigned pass = 0; pass < kPasses; ++pass) {
        sort_by_digit(items, other, pass * kDigitBits);
        items.swap(other);
    }
    order_equal_keys(items, values);
    return items;
}

}  // namespace

VertexOrder vertex_order(std::span<const double> values) {
    VertexOrder order;
    const std::size_t n = values.size();
    order.vertices.resize(n);
    order.rank.resize(n);
    if (n == 0) return order;
    const auto [lowest, highest] = std::ranges::minmax(values);
    const double scale = std::numeric_limits<std::uint32_t>::max() / (highest - lowest);
    if (highest - lowest > 0 && std::isfinite(highest - lowest) && std::isfinite(scale)) {
        const std::vector<Item> items = sorted_items(values, lowest, scale);
        for_blocks(n, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t r = begin; r < end; ++r) {
                order.vertices[r] = items[r].index;
                order.rank[items[r].index] = static_cast<std::uint32_t>(r);
            }
        });
        return order;
    }
    std::iota(order.vertices.begin(), order.vertices.end(), 0u);
    if (highest > lowest)  // a range that doubles can't tell apart
        std::ranges::stable_sort(order.vertices, {}, [&](std::uint32_t v) { return values[v]; });
    for (std::size_t r = 0; r < n; ++r) order.rank[order.vertices[r]] = static_cast<std::uint32_t>(r);
    return order;
}

}  // namespace stratareeb
