// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cotangent_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kThin = 1e-4;  // height over length of a triangle that is as good as a line

//! Twice the area with the sign of the plan's orientation; a triangle in space counts as turned upward.
double twice_area(const std::array<Point3, 3>& p, WeightSpace space) {
    const Point3 normal = cross_product(p[1] - p[0], p[2] - p[0]);
    return space == WeightSpace::Plan ? normal.z : magnitude(normal);
}

}  // namespace

CotangentWeights cotangent_weights(const TriangleSoup& soup, WeightSpace space,
                                   const std::vector<bool>& is_asked) {
    const std::size_t n = soup.points.size();
    CotangentWeights weights{
        .edges = {}, .area = std::vector<double>(n, 0), .is_regular = std::vector<bool>(n, true)};
    std::vector<signed char> turn(n, 0);
    for (const auto& t : soup.triangles) {
        if (!is_asked[t[0]] && !is_asked[t[1]] && !is_asked[t[2]]) continue;
        std::array<Point3, 3> p{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
        if (space == WeightSpace::Plan)
            for (Point3& corner : p) corner.z = 0;
        const double area = twice_area(p, space);
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, magnitude(p[(i + 1) % 3] - p[i]));
        const bool is_thin = !(std::abs(area) > kThin * longest * longest);
        const signed char side = area > 0 ? 1 : -1;
        for (std::size_t i = 0; i < 3; ++i) {
            if (is_thin || (turn[t[i]] != 0 && turn[t[i]] != side)) weights.is_regular[t[i]] = false;
            turn[t[i]] = side;
            weights.area[t[i]] += std::abs(area) / 6;
            if (is_thin) continue;
            const Point3 &at = p[i], &b = p[(i + 1) % 3], &c = p[(i + 2) % 3];
            weights.edges.push_back(
                {t[(i + 1) % 3], t[(i + 2) % 3], dot_product(b - at, c - at) / std::abs(area) / 2});
        }
    }
    return weights;
}

}  // namespace stratareeb
