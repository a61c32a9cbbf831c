// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_soup.h"

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

//! Which triangles to turn so that neighbours are wound alike. Neighbours meet across edges of two triangles and are visited
//! breadth first: where a one-sided piece must be cut, it is cut across and not in a spiral. Each piece turns its minority.
std::vector<bool> triangles_to_turn(const TriangleSoup& soup, const SoupTopology& topology) {
    std::vector<bool> turn(soup.triangles.size(), false), is_known(soup.triangles.size(), false);
    for (std::uint32_t seed = 0; seed < soup.triangles.size(); ++seed) {
        if (is_known[seed]) continue;
        std::vector<std::uint32_t> piece{seed};
        is_known[seed] = true;
        std::size_t turned = 0;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (std::uint32_t side = 3 * piece[i]; side < 3 * piece[i] + 3; ++side) {
                const auto sides = topology.sides_of(topology.edge_of_side[side]);
                if (sides.size() != 2) continue;
                const std::uint32_t other = sides[0] == side ? sides[1] : sides[0], t = other / 3;
                if (is_known[t]) continue;
                is_known[t] = true;
                const bool same_way = vertex_at(soup, side) == vertex_at(soup, other);
                turn[t] = turn[piece[i]] != same_way;
                turned += turn[t];
                piece.push_back(t);
            }
        if (2 * turned > piece.size())
            for (const std::uint32_t t : piece) turn[t] = !turn[t];
    }
    return turn;
}

//! The corners that stay together: those of each vertex that are joined across edges of two triangles wound alike.
//! Around a vertex such triangles follow each other in one sense, so what is joined there has no bad edge left.
DisjointSets fans_of_corners(const TriangleSoup& soup, const SoupTopology& topology) {
    DisjointSets fans(3 * soup.triangles.size());
    for (std::size_t e = 0; e < topology.edge_count(); ++e) {
        const auto sides = topology.sides_of(e);
        if (sides.size() != 2 || vertex_at(soup, sides[0]) == vertex_at(soup, sides[1])) continue;
        fans.unite(sides[0], next_corner(sides[1]));
        fans.unite(next_corner(sides[0]), sides[1]);
    }
    return fans;
}

//! A point for each fan: the vertex itself for its first one, copies at the end for the others.
void part_fans(OrientedSoup& result) {
    TriangleSoup& soup = result.soup;
    DisjointSets fans = fans_of_corners(soup, soup_topology(soup));
    const auto corners = static_cast<std::uint32_t>(3 * soup.triangles.size());
    std::vector<std::uint32_t> point_of_fan(corners, SoupTopology::kNone);
    std::vector<bool> is_taken(soup.points.size(), false);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        std::uint32_t& point = point_of_fan[fans.find(corner)];
        const std::uint32_t vertex = vertex_at(soup, corner);
        if (point == SoupTopology::kNone && !is_taken[vertex]) {
            point = vertex;
            is_taken[vertex] = true;
        } else if (point == SoupTopology::kNone) {
            point = static_cast<std::uint32_t>(soup.points.size());
            soup.points.push_back(soup.points[vertex]);
            result.source_point.push_back(vertex);
            ++result.copies;
        }
        soup.triangles[corner / 3][corner % 3] = point;
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
    result.soup = {soup.points, proper_triangles(soup, result)};
    const std::vector<bool> turn = triangles_to_turn(result.soup, soup_topology(result.soup));
    for (std::size_t t = 0; t < turn.size(); ++t) {
        if (turn[t]) std::swap(result.soup.triangles[t][1], result.soup.triangles[t][2]);
        result.turned += turn[t];
    }
    part_fans(result);
    return result;
}

}  // namespace stratareeb
