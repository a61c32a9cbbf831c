// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A closed polyline whose points carry parameters: a piecewise linear function of s that goes round once from 0 to 1.
//! The first point is not repeated. A single point is a contour too: what a summit or pit shrinks to.
struct SampledContour {
    std::vector<Point3> points;
    std::vector<double> parameters;  // one per point, in [0, 1), not falling; the first need not be 0
};

//! Parameters in proportion to the perimeter, 0 at the first point (thesis 2.1.2.1.3). Even ones where it is 0.
//! \throw InvalidInput if there are no points or one is not finite.
SampledContour contour_by_perimeter(std::vector<Point3> points);

//! \throw InvalidInput if sizes differ, there are no points, or parameters fall, leave [0, 1) or are not numbers.
void check_contour(const SampledContour& contour);

//! The contour's points at parameters s, each taken modulo 1. At a point's own parameter it is that point to the last bit.
//! Time in proportion to both sizes if s ascends.
std::vector<Point3> points_at(const SampledContour& contour, std::span<const double> s);
Point3 point_at(const SampledContour& contour, double s);

//! The same contour with parameters counted from `origin`: what was there is at 0 now, s stands for s + origin.
//! The thesis prints 1 - u + U for parameters u below the new origin U; what keeps them in order along the contour is 1 + u - U.
SampledContour with_origin(const SampledContour& contour, double origin);

//! The same contour, sides longer than `most` in even parts.
SampledContour with_short_sides(const SampledContour& contour, double most);

//! The mean over s in [0, 1]: with parameters by perimeter, the centre of the line (not of the area it encloses).
Point3 mean_point(const SampledContour& contour);

//! The mean distance between the points of two contours at these parameters, one at least.
double mean_distance(const SampledContour& a, const SampledContour& b, std::span<const double> s);

//! 0, 1/n, ..., (n - 1)/n.
std::vector<double> even_parameters(std::size_t n);

double perimeter(std::span<const Point3> points);

}  // namespace stratareeb
