// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/toroidal_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "boreholes/errors.h"
#include "reeb/coarse_to_fine.h"
#include "reeb/greedy_band.h"
#include "reeb/pinched_band.h"
#include "reeb/shortest_cycle.h"
#include "reeb/stair_paths.h"

namespace stratareeb {

namespace {

constexpr double kLargest = 1e75;              // whose fourth power is a number still
constexpr std::size_t kMostPoints = 1u << 28;  // rows and columns, counted twice around, fit 32 bits

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

void check(std::string_view which, std::span<const Point3> points, std::span<const double> parameters) {
    if (points.empty())
        throw InvalidInput(fmt::format("the {} contour has no points (a cap needs one)", which));
    if (points.size() > kMostPoints)
        throw InvalidInput(fmt::format("the {} contour has {} points: at most {} can be triangulated", which,
                                       points.size(), kMostPoints));
    const auto sound = [](double value) { return std::abs(value) <= kLargest; };
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!sound(points[i].x) || !sound(points[i].y) || !sound(points[i].z))
            throw InvalidInput(fmt::format(
                "point {} of the {} contour is ({}, {}, {}): expected finite numbers, at most {:g}", i, which,
                points[i].x, points[i].y, points[i].z, kLargest));
    if (!parameters.empty() && parameters.size() != points.size())
        throw InvalidInput(fmt::format("the {} contour has {} points but {} parameters (expected one each)",
                                       which, points.size(), parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (!std::isfinite(parameters[i]))
            throw InvalidInput(fmt::format("parameter {} of the {} contour is {}: expected a finite number",
                                           i, which, parameters[i]));
}

//! The parameters that the cost needs, closed contours' in [0, 1).
std::vector<double> parameters_of(std::span<const Point3> points, std::span<const double> given,
                                  const BandOptions& options) {
    if (options.cost != BandCost::ParameterDistance) return {};
    if (given.empty()) return length_parameters(points, options.closed);
    std::vector<double> parameters(given.begin(), given.end());
    if (options.closed)
        for (double& t : parameters) t -= std::floor(t);
    return parameters;
}

//! All spans from the one point of a closed contour.
SpanPath fan(const SpanContours& c) {
    const bool upper_moves = c.upper.size() > 1;
    const std::size_t count = std::max(c.upper.size(), c.lower.size());
    SpanPath path;
    if (count == 1) return path;
    path.upper_advances.assign(count, upper_moves ? 1 : 0);
    const SpanCosts costs(c, 0, 0);
    for (std::size_t step = 1; step <= count; ++step) {
        const auto i = static_cast<std::ptrdiff_t>(step);
        path.cost += upper_moves ? costs.arrivals(i, 0)[0] : costs.arrivals(0, i)[1];
    }
    return path;
}

SpanPath open_path(const SpanContours& c) {
    const SpanCosts costs(c, 0, 0);
    Corridor all;
    for (std::ptrdiff_t k = 0; k <= costs.rows() + costs.columns(); ++k) {
        all.lo.push_back(0);
        all.hi.push_back(static_cast<std::int32_t>(costs.rows()));
    }
    const auto path = StairPathFinder(costs, costs.rows()).shortest(0, all);
    return span_path(path.value(), c, 0, 0);
}

SpanPath greedy(const SpanContours& c, const BandOptions& options) {
    if (!options.first_span) return greedy_path(c, 0, nearest_lower_point(c, 0));
    const auto [i, j] = *options.first_span;
    if (i >= c.upper.size() || j >= c.lower.size())
        throw InvalidInput(fmt::format("the first span is ({}, {}), but the contours have {} and {} points",
                                       i, j, c.upper.size(), c.lower.size()));
    return greedy_path(c, i, j);
}

SpanPath path_between(const SpanContours& c, const BandOptions& options) {
    if (options.closed && (c.upper.size() == 1 || c.lower.size() == 1)) return fan(c);
    const bool is_greedy = options.method == BandMethod::Greedy;
    if (!options.closed) return is_greedy ? greedy_path(c, 0, 0) : open_path(c);
    SpanPath path = is_greedy ? greedy(c, options) : shortest_cycle(c);
    if (!is_pinched(path)) return path;
    path = opened(path, c);
    if (is_greedy) return path;
    for (const SpanPath& other : {coarse_to_fine_cycle(c), greedy_path(c, 0, nearest_lower_point(c, 0))})
        if (other.cost < path.cost && !is_pinched(other)) path = other;
    return path;
}

}  // namespace

std::vector<double> length_parameters(std::span<const Point3> points, bool closed) {
    std::vector<double> parameters;
    double length = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) length += distance(points[i - 1], points[i]);
        parameters.push_back(length);
    }
    if (points.empty()) return parameters;
    if (closed) length += distance(points.back(), points.front());
    const double steps = static_cast<double>(points.size()) - (closed ? 0 : 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        parameters[i] = length > 0 ? parameters[i] / length : steps > 0 ? static_cast<double>(i) / steps : 0;
    return parameters;
}

Band toroidal_band(std::span<const Point3> upper, std::span<const Point3> lower, const BandOptions& options) {
    check("upper", upper, options.upper_parameters);
    check("lower", lower, options.lower_parameters);
    const std::vector<double> s = parameters_of(upper, options.upper_parameters, options);
    const std::vector<double> t = parameters_of(lower, options.lower_parameters, options);
    const SpanContours contours{.upper = upper,
                                .lower = lower,
                                .upper_parameters = s,
                                .lower_parameters = t,
                                .cost = options.cost,
                                .closed = options.closed};
    Band band{.path = path_between(contours, options), .triangles = {}};
    band.triangles = band_triangles(band.path, static_cast<std::uint32_t>(upper.size()),
                                    static_cast<std::uint32_t>(lower.size()));
    return band;
}

}  // namespace stratareeb
