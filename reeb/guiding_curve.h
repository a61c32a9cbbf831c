// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! The curve that two contours follow to a critical point between them (thesis 2.1.2.4.1): from `start` at t = 0 through
//! `critical` at t = 1/2 to `end` at t = 1. In plan each half is a quarter of an ellipse over its height, upright at the
//! contour and level at the critical point, which makes the surface's tangent level there.
//! The printed formula weighs both points by 1 - sqrt(1 - (2t)^2); the first must have sqrt(1 - (2t)^2), or the curve would
//! start at 0.
struct QuadrantGuidingCurve {
    Point3 start, critical, end;

    //! \pre 0 <= t <= 1
    Point3 at(double t) const;
};

//! Where a guiding curve takes hold of a contour.
struct Guide {
    double parameter = 0;  // of the contour, s_i
    Point3 target;         // where that place goes
    double before = 0.25,
           after = 0.25;  // how far the contour follows: shares of it, above 0 to 1/2 (a_l and a_u)
};

//! 1 at `at`, falling evenly to 0 at `before` before it and `after` after it, the shorter way round the contour.
double hat_weight(double s, double at, double before, double after);

//! A contour drawn to its guides: f(s) + sum of weight(s, s_i) (F_i - f(s_i)). It passes through every target; it has the
//! contour's points, and new ones at s_i and at the feet of each hat.
//! The thesis prints (1 - weight) f(s) + weight F_i, which would gather the places near s_i at one point, even of the
//! given contour itself; moving them along with s_i keeps H(s, 0) = f(s).
//! \throw InvalidInput if the contour is none, a reach is out of range, or one guide reaches over another's place.
SampledContour guided_contour(const SampledContour& contour, std::span<const Guide> guides);

//! Where a level contour is nearest to a point in plan.
double nearest_parameter(const SampledContour& contour, const Point3& point);

//! The two places where a contour closes at a point: the nearest one, and the nearest one on the other side of the point.
//! \throw InvalidInput if all of the contour is on one side.
std::array<double, 2> pinch_parameters(const SampledContour& contour, const Point3& critical);

//! A contour on its way to the critical point, which its places at `parameters` reach: share 0 is the contour itself, 1 the
//! critical point's height, and the heights between are even steps of `share`.
//! Each place follows half a quadrant guiding curve, the rest goes straight up or down. `reach`: see Guide; no more than
//! the way to the next place.
SampledContour approach(const SampledContour& contour, std::span<const double> parameters,
                        const Point3& critical, double share, double reach = 0.25);

//! Merge: contours that touch at the critical point as one, with parameters by tracing one after another from there,
//! the first one first, then by direction so that the trace does not cross itself (two touch as an eight).
//! `parameters[i]`: the place of contour i that reaches the critical point.
//! \throw InvalidInput if there are fewer than two or counts differ.
SampledContour merged_contour(std::span<const SampledContour> contours, std::span<const double> parameters,
                              const Point3& critical, double reach = 0.25);

//! Divide: the contours that a contour falls into when its places at `parameters` meet at the critical point, each from
//! there with parameters by its own length. One per place: part i runs from place i (in order along the contour) to the next.
//! \throw InvalidInput if there are fewer than two places or two are the same.
std::vector<SampledContour> divided_contours(const SampledContour& contour,
                                             std::span<const double> parameters, const Point3& critical,
                                             double reach = 0.25);

}  // namespace stratareeb
