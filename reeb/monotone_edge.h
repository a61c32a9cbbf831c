// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reeb/curve.h"

namespace stratareeb {

//! Whether a curve's z only rises or only falls with t.
struct ZMonotonicity {
    bool monotone = false;
    int direction = 0;  // 1 rises from end to end, -1 falls, 0 neither
    // Where it first does not: over this stretch of t it runs against its direction, or level.
    double from = 0, to = 0;
    double from_z = 0, to_z = 0;
};

//! The thesis (2.1.2.1.2) looks at the control points, which a spline may overshoot between. Here each cubic piece is
//! judged by the extrema of z(t), the roots of a quadratic; a turn back within the rounding of z is none.
//! The curve may stand still in z at single places (z' = 0), but not along a stretch.
//! \throw InvalidInput unless the curve is an open line, Cardinal or Catmull-Rom spline.
ZMonotonicity z_monotonicity(const ParametricCurve& curve);

//! An edge of the enhanced Reeb graph: a curve that can be asked by height.
class MonotoneEdge {
 public:
    //! \throw InvalidInput if z is not monotone along the curve, with the stretch where it is not; or not a curve for edges.
    explicit MonotoneEdge(const Curve& curve);

    const ParametricCurve& curve() const { return curve_; }
    double lowest() const { return rising_ ? heights_.front() : -heights_.back(); }
    double highest() const { return rising_ ? heights_.back() : -heights_.front(); }
    //! The one t whose point is at z. \throw InvalidInput if z is outside [lowest, highest].
    double parameter_at(double z) const;
    //! The edge's point at height z; its z is z itself.
    Point3 at(double z) const;

 private:
    ParametricCurve curve_;
    bool rising_ = true;
    std::vector<double> heights_;  // at the joints, ascending: of -z if the curve falls
};

}  // namespace stratareeb
