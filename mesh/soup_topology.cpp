// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/soup_topology.h"

#include <algorithm>

namespace stratareeb {
namespace {

struct SideKey {
    std::uint32_t other;  // the larger vertex of the side
    std::uint32_t side;
    auto operator<=>(const SideKey&) const = default;
};

// Sides grouped by their smaller vertex: group v is keys[first[v]] up to keys[first[v + 1]], sorted.
struct SideGroups {
    std::vector<std::uint32_t> first;
    std::vector<SideKey> keys;
};

template <class Visit>
void for_each_side(const TriangleSoup& soup, Visit visit) {
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& triangle = soup.triangles[t];
        if (names_a_vertex_twice(triangle)) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            visit(low, SideKey{high, 3 * t + k});
        }
    }
}

SideGroups group_sides(const TriangleSoup& soup) {
    SideGroups groups;
    groups.first.assign(soup.points.size() + 1, 0);
    for_each_side(soup, [&](std::uint32_t low, SideKey) { ++groups.first[low + 1]; });
    std::partial_sum(groups.first.begin(), groups.first.end(), groups.first.begin());
    groups.keys.resize(groups.first.back());
    auto fill = groups.first;
    for_each_side(soup, [&](std::uint32_t low, SideKey key) { groups.keys[fill[low]++] = key; });
    for (std::size_t v = 0; v + 1 < groups.first.size(); ++v)
        std::sort(groups.keys.begin() + groups.first[v], groups.keys.begin() + groups.first[v + 1]);
    return groups;
}

void number_edges(const SideGroups& groups, SoupTopology& topology) {
    topology.sides.reserve(groups.keys.size());
    topology.first_side.reserve(groups.keys.size() / 2 + 1);
    for (std::size_t v = 0; v + 1 < groups.first.size(); ++v) {
        for (auto i = groups.first[v]; i < groups.first[v + 1]; ++i) {
            const auto& key = groups.keys[i];
            if (i == groups.first[v] || key.other != groups.keys[i - 1].other)
                topology.first_side.push_back(i);
            topology.sides.push_back(key.side);
            topology.edge_of_side[key.side] = static_cast<std::uint32_t>(topology.first_side.size() - 1);
        }
    }
    topology.first_side.push_back(static_cast<std::uint32_t>(topology.sides.size()));
}

// Corners meet across an edge if exactly two triangles do.
void join_fans(const TriangleSoup& soup, SoupTopology& topology) {
    DisjointSets fans(3 * soup.triangles.size());
    for (std::size_t e = 0; e < topology.edge_count(); ++e) {
        const auto sides = topology.sides_of(e);
        if (sides.size() != 2) continue;
        const auto a = sides[0], b = sides[1];
        const bool same_way = vertex_at(soup, a) == vertex_at(soup, b);
        fans.unite(a, same_way ? b : next_corner(b));
        fans.unite(next_corner(a), same_way ? next_corner(b) : b);
    }
    topology.fan_of_corner.resize(3 * soup.triangles.size());
    for (std::uint32_t c = 0; c < topology.fan_of_corner.size(); ++c)
        topology.fan_of_corner[c] = fans.find(c);
}

}  // namespace

SoupTopology soup_topology(const TriangleSoup& soup) {
    SoupTopology topology;
    topology.edge_of_side.assign(3 * soup.triangles.size(), SoupTopology::kNone);
    number_edges(group_sides(soup), topology);
    join_fans(soup, topology);
    return topology;
}

std::vector<std::uint32_t> corners_in_further_fans(const TriangleSoup& soup, const SoupTopology& topology) {
    std::vector<std::uint32_t> first(soup.points.size(), SoupTopology::kNone), further;
    for (std::uint32_t corner = 0; corner < topology.fan_of_corner.size(); ++corner) {
        if (topology.edge_of_side[corner] == SoupTopology::kNone) continue;
        std::uint32_t& known = first[vertex_at(soup, corner)];
        if (known == SoupTopology::kNone) known = topology.fan_of_corner[corner];
        if (known != topology.fan_of_corner[corner]) further.push_back(corner);
    }
    return further;
}

}  // namespace stratareeb
