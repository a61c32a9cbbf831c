// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_crossings.h"

#include <algorithm>
#include <bit>
#include <ranges>
#include <tuple>
#include <utility>
#include <vector>

namespace stratareeb {

namespace {

constexpr std::size_t kMostKnown = 100'000;  // pairs that are kept from one surface to the next

std::uint64_t mixed(std::uint64_t x) {  // the finish of splitmix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

std::uint64_t hash_of(const std::array<Point3, 3>& corners) {
    std::uint64_t hash = 0;
    for (const Point3& p : corners)
        for (const double x : {p.x, p.y, p.z})
            hash = mixed(hash + 0x9e3779b97f4a7c15U + std::bit_cast<std::uint64_t>(x + 0.0));  // + 0: no -0
    return hash;
}

//! From the least one on, so that they don't depend on where a triangle begins.
std::array<Point3, 3> corners_of(const TriangleSoup& soup, std::size_t t) {
    std::array<Point3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = soup.points[soup.triangles[t][i]];
    std::ranges::rotate(corners, std::ranges::min_element(
                                     corners, {}, [](const Point3& p) { return std::tuple(p.x, p.y, p.z); }));
    return corners;
}

}  // namespace

SelfIntersections CrossingSearch::of(const TriangleSoup& soup, std::size_t named) {
    const std::size_t count = soup.triangles.size();
    std::vector<Corners> triangles(count);
    Order order(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        triangles[t] = corners_of(soup, t);
        order[t] = {hash_of(triangles[t]), t};
    }
    std::ranges::sort(order);
    std::vector<bool> is_new(count, true);
    std::vector<std::uint32_t> now(triangles_.size(), ~0u);  // by triangle of the surface before
    for (std::size_t i = 0, k = 0; is_known_ && i < order.size() && k < order_.size();) {
        const auto& [hash, t] = order[i];
        const auto& [hash_before, before] = order_[k];
        if (hash == hash_before && triangles[t] == triangles_[before]) {
            is_new[t] = false;
            now[before] = t;
        }
        i += hash <= hash_before;
        k += hash_before <= hash;
    }
    SelfIntersections found = self_intersections_of(soup, is_new, std::max(named, kMostKnown));
    for (const auto& [a, b] : crossing_) {
        if (now[a] == ~0u || now[b] == ~0u) continue;
        ++found.count;
        found.first.push_back({std::min(now[a], now[b]), std::max(now[a], now[b])});
    }
    std::ranges::sort(found.first);
    remember(std::move(triangles), std::move(order), found);
    if (found.first.size() > named) found.first.resize(named);
    return found;
}

void CrossingSearch::remember(std::vector<Corners> triangles, Order order, const SelfIntersections& found) {
    triangles_ = std::move(triangles);
    order_ = std::move(order);
    is_known_ = found.count == found.first.size();
    crossing_.clear();
    if (is_known_) crossing_ = found.first;
}

}  // namespace stratareeb
