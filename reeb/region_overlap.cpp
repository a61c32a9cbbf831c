// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/region_overlap.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <vector>

namespace stratareeb {

namespace {

constexpr std::size_t kLeastSlabs = 256, kMostSlabs = 4096;

struct Edge {
    Point2 low, high;
    int level = 0;
    std::uint32_t ring = 0;

    double x_at(double y) const { return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x); }
};

struct Crossing {
    double x = 0;
    int level = 0;
    std::uint32_t ring = 0;
    friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

void add_edges(const StackLevel& level, int number, std::span<const std::uint32_t> rings,
               std::vector<Edge>& edges) {
    for (const std::uint32_t r : rings) {
        Point2 a = level.ring(r).back();
        for (const Point2& b : level.ring(r)) {
            if (a.y < b.y) edges.push_back({a, b, number, r});
            if (b.y < a.y) edges.push_back({b, a, number, r});
            a = b;
        }
    }
}

std::vector<double> slab_ends(const std::vector<Edge>& edges) {
    std::vector<double> ends;
    for (const Edge& edge : edges) ends.insert(ends.end(), {edge.low.y, edge.high.y});
    const auto [lowest, highest] = std::ranges::minmax(ends);
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const bool too_many = ends.size() > kMostSlabs;
    if (too_many) ends.clear();
    const std::size_t even = too_many ? kMostSlabs : kLeastSlabs;
    for (std::size_t i = 0; i <= even; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(even);
        ends.push_back(lowest + share * (highest - lowest));
    }
    std::ranges::sort(ends);
    return ends;
}

std::uint32_t region_around(const StackLevel& level, std::span<const std::uint32_t> rings) {
    return level.parent(
        *std::ranges::min_element(rings, {}, [&](std::uint32_t r) { return level.depth(r); }));
}

}  // namespace

RegionOverlaps region_overlaps(const StackLevel& lower, std::span<const std::uint32_t> lower_rings,
                               const StackLevel& upper, std::span<const std::uint32_t> upper_rings) {
    const std::array levels{&lower, &upper};
    const std::array around{region_around(lower, lower_rings), region_around(upper, upper_rings)};
    std::vector<Edge> edges;
    add_edges(lower, 0, lower_rings, edges);
    add_edges(upper, 1, upper_rings, edges);
    std::ranges::stable_sort(edges, {}, [](const Edge& edge) { return edge.low.y; });
    const std::vector<double> ends = slab_ends(edges);
    RegionOverlaps overlaps;
    std::vector<std::size_t> active;
    std::vector<Crossing> crossings;
    std::size_t next = 0;
    for (std::size_t s = 0; s + 1 < ends.size(); ++s) {
        const double height = ends[s + 1] - ends[s], y = ends[s] + height / 2;
        if (!(height > 0)) continue;
        while (next < edges.size() && edges[next].low.y <= y) active.push_back(next++);
        std::erase_if(active, [&](std::size_t e) { return edges[e].high.y <= y; });
        crossings.clear();
        for (const std::size_t e : active)
            crossings.push_back({edges[e].x_at(y), edges[e].level, edges[e].ring});
        std::ranges::sort(crossings);
        std::array region = around;
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            const auto& [x, level, ring] = crossings[i];
            auto& current = region[static_cast<std::size_t>(level)];
            current = current == ring ? levels[static_cast<std::size_t>(level)]->parent(ring) : ring;
            if (i + 1 < crossings.size())
                overlaps[{region[0], region[1]}] += (crossings[i + 1].x - x) * height;
        }
    }
    overlaps[{around[0], around[1]}] = std::numeric_limits<double>::infinity();
    return overlaps;
}

}  // namespace stratareeb
