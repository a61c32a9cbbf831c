// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/greedy_band.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

struct Vector {
    double x, y, z;
};

Vector between(const Point3& a, const Point3& b) {
    return {b.x - a.x, b.y - a.y, b.z - a.z};
}

double squared(const Vector& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
    const Vector u = between(a, b), v = between(a, c);
    return std::sqrt(squared({u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x})) / 2;
}

double span_distance(const SpanContours& c, std::uint32_t i, std::uint32_t j) {
    if (c.cost != BandCost::ParameterDistance) return squared(between(c.upper[i], c.lower[j]));
    const double distance = std::abs(c.upper_parameters[i] - c.lower_parameters[j]);
    return c.closed ? std::min(distance, 1 - distance) : distance;
}

}  // namespace

std::uint32_t nearest_lower_point(const SpanContours& c, std::uint32_t upper) {
    std::uint32_t nearest = 0;
    for (std::uint32_t j = 1; j < c.lower.size(); ++j)
        if (span_distance(c, upper, j) < span_distance(c, upper, nearest)) nearest = j;
    return nearest;
}

SpanPath greedy_path(const SpanContours& c, std::uint32_t first_upper, std::uint32_t first_lower) {
    const auto m = static_cast<std::uint32_t>(c.upper.size()), n = static_cast<std::uint32_t>(c.lower.size());
    std::uint32_t up_left = c.closed ? m : m - 1, low_left = c.closed ? n : n - 1;
    SpanPath path{.upper = first_upper, .lower = first_lower, .upper_advances = {}, .cost = 0};
    path.upper_advances.reserve(up_left + low_left);
    const auto next = [](std::uint32_t i, std::uint32_t size) { return i + 1 == size ? 0 : i + 1; };
    std::uint32_t i = first_upper, j = first_lower;
    while (up_left + low_left > 0) {
        const std::uint32_t up = next(i, m), low = next(j, n);
        const double after_up = span_distance(c, up, j), after_low = span_distance(c, i, low);
        const bool moves_up = low_left == 0 || (up_left > 0 && after_up < after_low);
        if (c.cost == BandCost::Area)
            path.cost += moves_up ? triangle_area(c.upper[i], c.upper[up], c.lower[j])
                                  : triangle_area(c.upper[i], c.lower[j], c.lower[low]);
        else
            path.cost += c.cost == BandCost::SpanLength ? std::sqrt(moves_up ? after_up : after_low)
                         : moves_up                     ? after_up
                                                        : after_low;
        path.upper_advances.push_back(moves_up ? 1 : 0);
        (moves_up ? i : j) = moves_up ? up : low;
        --(moves_up ? up_left : low_left);
    }
    return path;
}

}  // namespace stratareeb
