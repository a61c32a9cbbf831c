// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reeb/curve.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! A curve's length and its parameter by length (thesis 2.1.2.1.3): exact for lines and polygons; a circle's is its angle;
//! any other curve is approximated by a polygon with corners on it, refined until each part of it is short by no more
//! than `tolerance` of its length, as told by comparing one chord with four.
class ArcLength {
 public:
    explicit ArcLength(const ParametricCurve& curve, double tolerance = 1e-6);

    double length() const { return lengths_.back(); }
    //! What the length is short of the true one, estimated from the last refinement; 0 for lines and circles.
    double error() const { return error_; }
    //! t in [0, 1] with that share of the length, in [0, 1], behind it. In a curve without length they are the same.
    double parameter_at(double share) const;
    double share_at(double t) const;

 private:
    void add(double t, double length);
    void refine(const ParametricCurve& curve, double from, double to, double tolerance, int depth);

    std::vector<double> parameters_{0}, lengths_{0};  // of the polygon's corners, ascending
    double error_ = 0;
};

//! A closed curve as a contour with parameters by length: a polygon's own vertices, whatever `count`;
//! `count` evenly spaced points of any other curve.
//! \throw InvalidInput if the curve is not closed, or not a curve, or `count` is below 3 where it counts.
SampledContour sample_contour(const Curve& curve, std::size_t count);

}  // namespace stratareeb
