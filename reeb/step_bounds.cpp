// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/step_bounds.h"

#include <algorithm>
#include <cmath>

#include "reeb/point_run_tree.h"

namespace stratareeb {

namespace {

constexpr double kRounding = 1e-13;  // of the contours' extent: more than a distance can be wrong
constexpr double kTolerance = 0.02;  // bounds this much too low cost less than closer ones would save

double extent(const SpanContours& contours) {
    Point3 low = contours.upper.front(), high = low;
    for (const auto points : {contours.upper, contours.lower})
        for (const Point3& p : points) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

//! The bound of the step that arrives at point i.
double step_bound(BandCost cost, std::span<const Point3> points, std::size_t i, const PointRunTree& others,
                  std::uint32_t guess, double rounding) {
    const Point3 end = points[i], start = points[i == 0 ? points.size() - 1 : i - 1];
    if (cost == BandCost::SpanLength)
        return std::max(0.0, others.distance(end, {}, guess, kTolerance) - rounding);
    const Point3 edge{end.x - start.x, end.y - start.y, end.z - start.z};
    const double length = std::hypot(edge.x, edge.y, edge.z);
    if (!(length > 0)) return 0;
    const Point3 direction{edge.x / length, edge.y / length, edge.z / length};
    return length / 2 * std::max(0.0, others.distance(end, direction, guess, kTolerance) - rounding);
}

std::vector<double> sums_along(const std::vector<double>& bounds, std::uint32_t first, std::size_t count) {
    std::vector<double> sums(count + 1, 0);
    for (std::size_t i = 1; i <= count; ++i) sums[i] = sums[i - 1] + bounds[(first + i) % bounds.size()];
    return sums;
}

}  // namespace

StepBounds step_bounds(const SpanContours& c, std::uint32_t first_upper, std::uint32_t first_lower,
                       const SpanPath& hint) {
    const std::size_t m = c.upper.size(), n = c.lower.size();
    std::vector<double> upper(m), lower(n);
    if (c.cost != BandCost::ParameterDistance) {
        const double rounding = kRounding * extent(c);
        const PointRunTree uppers(c.upper), lowers(c.lower);
        std::uint32_t i = hint.upper, j = hint.lower;
        for (const bool upper_moves : hint.upper_advances)
            if (upper_moves) {
                i = i + 1 == m ? 0 : i + 1;
                upper[i] = step_bound(c.cost, c.upper, i, lowers, j, rounding);
            } else {
                j = j + 1 == n ? 0 : j + 1;
                lower[j] = step_bound(c.cost, c.lower, j, uppers, i, rounding);
            }
    }
    return {sums_along(upper, first_upper, 2 * m), sums_along(lower, first_lower, n)};
}

}  // namespace stratareeb
