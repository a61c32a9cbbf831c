// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/plan_fairing.h"

#include <cstdint>

namespace stratareeb {

namespace {

// A step in and a step out.
constexpr double kShrink = 0.5, kGrow = -0.53;

//! By free vertex: the ends of its directed edges, each neighbour once, for a closed surface.
struct Neighbours {
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> vertices;
};

Neighbours neighbours_of(const TriangleSoup& soup, const std::vector<bool>& is_free) {
    Neighbours neighbours{.first = std::vector<std::size_t>(soup.points.size() + 1, 0), .vertices = {}};
    for (const auto& t : soup.triangles)
        for (const std::uint32_t v : t) neighbours.first[v + 1] += is_free[v];
    for (std::size_t v = 0; v < soup.points.size(); ++v) neighbours.first[v + 1] += neighbours.first[v];
    neighbours.vertices.resize(neighbours.first.back());
    std::vector<std::size_t> next(neighbours.first.begin(), neighbours.first.end() - 1);
    for (const auto& t : soup.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (is_free[t[i]]) neighbours.vertices[next[t[i]]++] = t[(i + 1) % 3];
    return neighbours;
}

}  // namespace

void fair_in_plan(TriangleSoup& soup, const std::vector<bool>& is_free, std::size_t rounds) {
    const Neighbours neighbours = neighbours_of(soup, is_free);
    std::vector<Point3> moved = soup.points;
    for (std::size_t round = 0; round < 2 * rounds; ++round) {
        for (std::size_t v = 0; v < soup.points.size(); ++v) {
            const std::size_t begin = neighbours.first[v], end = neighbours.first[v + 1];
            if (begin == end) continue;
            const Point3& here = soup.points[v];
            double x = 0, y = 0;
            for (std::size_t k = begin; k < end; ++k) {
                const Point3& there = soup.points[neighbours.vertices[k]];
                x += there.x - here.x;
                y += there.y - here.y;
            }
            const double share = (round % 2 == 0 ? kShrink : kGrow) / static_cast<double>(end - begin);
            moved[v].x = here.x + share * x;
            moved[v].y = here.y + share * y;
        }
        soup.points = moved;
    }
}

}  // namespace stratareeb
