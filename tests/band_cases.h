// SPDX-License-Identifier: GPL-3.0-or-later
// Contours to triangulate between, and bands by other means: straight from the definitions, with nothing of reeb/ in them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "boreholes/point.h"
#include "reeb/span_path.h"

namespace stratareeb::band_cases {

using Points = std::vector<Point3>;

inline double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

inline double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y,
                 vz = c.z - a.z;
    return std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

//! A problem and the cost of its steps by definition.
struct Problem {
    Points upper, lower;
    BandCost cost = BandCost::Area;
    bool closed = true;
    std::vector<double> s = {}, t = {};

    const Point3& u(std::size_t i) const { return upper[i % upper.size()]; }
    const Point3& l(std::size_t j) const { return lower[j % lower.size()]; }
    double span(std::size_t i, std::size_t j) const {
        if (cost == BandCost::SpanLength) return distance(u(i), l(j));
        const double d = std::abs(s[i % s.size()] - t[j % t.size()]);
        return closed ? std::min(d, 1 - d) : d;
    }
    double up(std::size_t i, std::size_t j) const {
        return cost == BandCost::Area ? triangle_area(u(i), u(i + 1), l(j)) : span(i + 1, j);
    }
    double low(std::size_t i, std::size_t j) const {
        return cost == BandCost::Area ? triangle_area(u(i), l(j), l(j + 1)) : span(i, j + 1);
    }
    std::size_t rise() const { return upper.size() - (closed ? 0 : 1); }
    std::size_t run() const { return lower.size() - (closed ? 0 : 1); }
};

//! The least cost from one first span: a full table.
inline double cost_from(const Problem& p, std::size_t i0, std::size_t j0) {
    const std::size_t m = p.rise(), n = p.run();
    std::vector<double> row(n + 1);
    for (std::size_t a = 0; a <= m; ++a)
        for (std::size_t b = 0; b <= n; ++b) {
            double best = a == 0 && b == 0 ? 0 : std::numeric_limits<double>::infinity();
            if (a > 0) best = std::min(best, row[b] + p.up(i0 + a - 1, j0 + b));
            if (b > 0) best = std::min(best, row[b - 1] + p.low(i0 + a, j0 + b - 1));
            row[b] = best;
        }
    return row[n];
}

//! The least cost over all first spans.
inline double least_cost(const Problem& p) {
    if (!p.closed) return cost_from(p, 0, 0);
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.upper.size(); ++i) best = std::min(best, cost_from(p, i, 0));
    return best;
}

//! The least cost over all paths from a span, one after the other.
inline double enumerated_cost(const Problem& p, std::size_t i, std::size_t j, std::size_t up_left,
                              std::size_t low_left) {
    if (up_left + low_left == 0) return 0;
    double best = std::numeric_limits<double>::infinity();
    if (up_left > 0) best = std::min(best, p.up(i, j) + enumerated_cost(p, i + 1, j, up_left - 1, low_left));
    if (low_left > 0)
        best = std::min(best, p.low(i, j) + enumerated_cost(p, i, j + 1, up_left, low_left - 1));
    return best;
}

//! What a path costs, added up along it.
inline double cost_along(const Problem& p, const SpanPath& path) {
    std::size_t i = path.upper, j = path.lower;
    double sum = 0;
    for (const bool up : path.upper_advances) {
        sum += up ? p.up(i, j) : p.low(i, j);
        ++(up ? i : j);
    }
    return sum;
}

//! A circle with harmonics (a smooth, possibly concave outline), and normal noise on each point's radius.
inline Points wobbly_circle(std::size_t count, double radius, double z, double harmonics, double noise,
                            std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::array<double, 5> size{}, phase{};
    for (std::size_t h = 0; h < size.size(); ++h)
        size[h] = harmonics * normal(random), phase[h] = 6 * normal(random);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        double r = 1 + noise * normal(random);
        for (std::size_t h = 0; h < size.size(); ++h)
            r += size[h] * std::cos(static_cast<double>(h + 2) * angle + phase[h]);
        points.push_back({radius * r * std::cos(angle), radius * r * std::sin(angle), z});
    }
    return points;
}

//! Points on a small integer grid: ties, coincident and collinear points, self-crossing contours.
inline Points grid_points(std::size_t count, int size, std::mt19937& random) {
    std::uniform_int_distribution<int> place(0, size);
    Points points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({double(place(random)), double(place(random)), double(place(random))});
    return points;
}

inline std::vector<double> even_parameters(std::size_t count, double first) {
    std::vector<double> parameters;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = first + static_cast<double>(i) / static_cast<double>(count);
        parameters.push_back(t - std::floor(t));
    }
    return parameters;
}

}  // namespace stratareeb::band_cases
