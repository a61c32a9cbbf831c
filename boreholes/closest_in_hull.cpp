// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/closest_in_hull.h"

#include <cmath>

namespace stratareeb {

std::vector<Point2> closest_in_hull(const HoleTriangulation& holes, std::span<const Point2> where) {
    std::vector<Point2> result(where.begin(), where.end());
    const auto& sites = holes.sites();
    const std::vector<PlanLocation> locations = holes.locate(where);
    for (std::size_t i = 0; i < where.size(); ++i) {
        const PlanLocation& l = locations[i];
        if (l.inside) continue;
        // From the heaviest corner, so that a corner itself is met to the last bit.
        int heaviest = 0;
        for (int k = 1; k < 3; ++k)
            if (l.weight[k] > l.weight[heaviest]) heaviest = k;
        const Point2& from = sites[l.site[heaviest]];
        result[i] = from;
        for (int k = 0; k < 3; ++k) {
            result[i].x += l.weight[k] * (sites[l.site[k]].x - from.x);
            result[i].y += l.weight[k] * (sites[l.site[k]].y - from.y);
        }
    }
    return result;
}

std::vector<Point2> closest_in_reach(const HoleTriangulation& holes, std::span<const Point2> where,
                                     double reach) {
    std::vector<Point2> result = closest_in_hull(holes, where);
    for (std::size_t i = 0; i < where.size(); ++i) {
        const double dx = where[i].x - result[i].x, dy = where[i].y - result[i].y, away = std::hypot(dx, dy);
        if (away <= reach)
            result[i] = where[i];
        else
            result[i] = {result[i].x + dx * (reach / away), result[i].y + dy * (reach / away)};
    }
    return result;
}

}  // namespace stratareeb
