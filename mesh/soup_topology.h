// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Who belongs together: sets of 0..n-1 that can be united. The smallest member stands for its set, whatever
//! the order of uniting was.
class DisjointSets {
 public:
    explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a < b) parent_[b] = a;
        if (b < a) parent_[a] = b;
    }

 private:
    std::vector<std::uint32_t> parent_;
};

//! How the triangles of a soup hang together. Corner k of triangle t has number 3t+k; so has the side that
//! runs from that corner to the next. A triangle that names a vertex twice is no triangle: its sides belong
//! to no edge.
struct SoupTopology {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> edge_of_side;  // per side; kNone for a triangle that names a vertex twice
    std::vector<std::uint32_t> sides;         // grouped by edge; edges by smaller, then larger vertex
    std::vector<std::uint32_t> first_side;  // edge e has sides[first_side[e]] up to sides[first_side[e + 1]]
    std::vector<std::uint32_t> fan_of_corner;  // corners at one vertex joined across edges of two triangles

    std::size_t edge_count() const { return first_side.size() - 1; }
    std::span<const std::uint32_t> sides_of(std::size_t edge) const {
        return std::span(sides).subspan(first_side[edge], first_side[edge + 1] - first_side[edge]);
    }
};

SoupTopology soup_topology(const TriangleSoup& soup);

//! Corners, ascending, that are in another fan than the first corner at their vertex: none where each vertex has one fan. Triangles that name
//! a vertex twice are left out.
std::vector<std::uint32_t> corners_in_further_fans(const TriangleSoup& soup, const SoupTopology& topology);

inline std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
inline std::uint32_t previous_corner(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}
inline std::uint32_t vertex_at(const TriangleSoup& soup, std::uint32_t corner) {
    return soup.triangles[corner / 3][corner % 3];
}
inline bool names_a_vertex_twice(const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace stratareeb
