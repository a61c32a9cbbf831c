// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/sliding_homotopy.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

void shift(std::vector<Point3>& points, const Point3& by) {
    if (by == Point3{}) return;  // a given contour stays as it is, to the sign of its zeros
    for (Point3& p : points) p += by;
}

}  // namespace

double sliding_weight(double t) {
    const double s = std::sin(std::numbers::pi * t);
    return t == 1 ? 0 : s * s;  // the same, and not below 0
}

SlidingHomotopy::SlidingHomotopy(ContourHomotopy homotopy, MonotoneEdge edge)
    : homotopy_(std::move(homotopy)), edge_(std::move(edge)) {
    const double low = homotopy_.levels().front(), high = homotopy_.levels().back();
    if (!(edge_.lowest() <= low && edge_.highest() >= high)) {
        throw InvalidInput(fmt::format(
            "sliding homotopy: the edge runs from z = {} to {} (expected it to reach from the lowest "
            "contour at {} to the highest at {})",
            edge_.lowest(), edge_.highest(), low, high));
    }
}

Point3 SlidingHomotopy::sliding_vector(std::size_t interval, double t) const {
    if (t == 0 || t == 1) return {};
    const double start = homotopy_.level(interval, 0);
    const Point3 edge_vector = edge_.at(homotopy_.level(interval, t)) - edge_.at(start);
    const Point3 homotopy_vector = homotopy_.mean(interval, t) - homotopy_.mean(interval, 0);
    return sliding_weight(t) * (edge_vector - homotopy_vector);
}

Point3 SlidingHomotopy::at(double s, std::size_t interval, double t) const {
    return contour_at(std::span(&s, 1), interval, t).front();
}

std::vector<Point3> SlidingHomotopy::contour_at(std::span<const double> s, std::size_t interval,
                                                double t) const {
    auto points = homotopy_.contour_at(s, interval, t);
    shift(points, sliding_vector(interval, t));
    return points;
}

SampledContour SlidingHomotopy::contour(std::size_t interval, double t) const {
    auto contour = homotopy_.contour(interval, t);
    shift(contour.points, sliding_vector(interval, t));
    return contour;
}

std::vector<SampledContour> SlidingHomotopy::contours_between(std::size_t interval, std::size_t steps) const {
    auto contours = homotopy_.contours_between(interval, steps);
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const double t = static_cast<double>(i + 1) / static_cast<double>(steps);
        shift(contours[i].points, sliding_vector(interval, t));
    }
    return contours;
}

}  // namespace stratareeb
