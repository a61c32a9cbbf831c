// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cut_crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/ring_crossings.h"

namespace stratareeb {

namespace {

constexpr std::size_t kMostCuts = 100;

double plan_length(const std::vector<Point3>& points, std::size_t from, std::size_t to) {
    double length = 0;
    for (std::size_t i = from; i < to; ++i) {
        const Point3 &a = points[i % points.size()], &b = points[(i + 1) % points.size()];
        length += std::hypot(b.x - a.x, b.y - a.y);
    }
    return length;
}

}  // namespace

bool cut_crossings(std::vector<Point3>& points, double most_share) {
    std::vector<Point3> line = points;
    for (std::size_t cuts = 0; cuts <= kMostCuts && line.size() > 2; ++cuts) {
        std::vector<std::vector<Point2>> ring(1);
        for (const Point3& p : line) ring[0].push_back({p.x, p.y});
        const auto crossings = ring_crossings(ring, {.most = 1});
        if (crossings.empty()) {
            points = std::move(line);
            return true;
        }
        // From the end of the first edge to the start of the second, or the other way round.
        const auto [first, second] = std::minmax({crossings[0].edge, crossings[0].other_edge});
        const double inner = plan_length(line, first + 1, second),
                     outer = plan_length(line, second + 1, first + line.size());
        if (std::min(inner, outer) > most_share * plan_length(line, 0, line.size())) return false;
        if (inner <= outer)
            line.erase(line.begin() + first + 1, line.begin() + second + 1);
        else
            line.assign(line.begin() + first + 1, line.begin() + second + 1);
    }
    return false;
}

}  // namespace stratareeb
