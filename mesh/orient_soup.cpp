// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "boreholes/errors.h"
#include "mesh/soup_topology.h"

namespace stratareeb {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

Triangle sorted(Triangle t) {
    std::ranges::sort(t);
    return t;
}

//! Triangles with three corners, the first of each three corners.
std::vector<Triangle> proper_triangles(const TriangleSoup& soup, OrientedSoup& result) {
    std::vector<std::uint32_t> by_corners;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
        if (names_a_vertex_twice(soup.triangles[t]))
            ++result.degenerate;
        else
            by_corners.push_back(t);
    std::ranges::stable_sort(by_corners, {}, [&](std::uint32_t t) { return sorted(soup.triangles[t]); });
    const auto repeated =
        std::ranges::unique(by_corners, {}, [&](std::uint32_t t) { return sorted(soup.triangles[t]); });
    result.duplicate = repeated.size();
    by_corners.erase(repeated.begin(), repeated.end());
    std::ranges::sort(by_corners);
    std::vector<Triangle> triangles;
    for (const std::uint32_t t : by_corners) triangles.push_back(soup.triangles[t]);
    return triangles;
}

//! Is a triangle wound as another one with corners in the same places?
bool is_wound_alike(const Triangle& a, const Triangle& b, const std::vector<std::uint32_t>& source) {
    const auto first = std::ranges::find(b, source[a[0]]);
    return b[(first - b.begin() + 1) % 3] == source[a[1]];
}

//! Wind each piece as most of its triangles were.
void follow_the_majority(const std::vector<Triangle>& before, OrientedSoup& result) {
    auto& triangles = result.soup.triangles;
    DisjointSets pieces(result.source_point.size());
    for (const Triangle& t : triangles) {
        pieces.unite(t[0], t[1]);
        pieces.unite(t[0], t[2]);
    }
    std::vector<std::int64_t> majority(result.source_point.size(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        majority[pieces.find(triangles[t][0])] +=
            is_wound_alike(triangles[t], before[t], result.source_point) ? 1 : -1;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (majority[pieces.find(triangles[t][0])] < 0) std::swap(triangles[t][1], triangles[t][2]);
        result.turned += !is_wound_alike(triangles[t], before[t], result.source_point);
    }
}

bool is_sound(const TriangleSoup& soup) {
    try {
        half_edge_mesh(soup);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

void require_known_vertices(const TriangleSoup& soup) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (const auto v : soup.triangles[t])
            if (v >= soup.points.size())
                throw InvalidInput(
                    fmt::format("triangle {} names vertex {} of {}", t, v, soup.points.size()));
}

}  // namespace

OrientedSoup orient_soup(const TriangleSoup& soup) {
    require_known_vertices(soup);
    OrientedSoup result;
    result.source_point.resize(soup.points.size());
    std::iota(result.source_point.begin(), result.source_point.end(), 0u);
    if (is_sound(soup)) {
        result.soup = soup;
        return result;
    }
    const std::vector<Triangle> before = proper_triangles(soup, result);
    result.soup.triangles = before;
    // CGAL only copies points, it does not look at them: numbers will do, and tell where a copy comes from.
    CGAL::Polygon_mesh_processing::orient_polygon_soup(result.source_point, result.soup.triangles);
    for (const std::uint32_t p : result.source_point) result.soup.points.push_back(soup.points[p]);
    result.copies = result.soup.points.size() - soup.points.size();
    follow_the_majority(before, result);
    return result;
}

}  // namespace stratareeb
