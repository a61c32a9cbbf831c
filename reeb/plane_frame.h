// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/point.h"

namespace stratareeb {

//! Three unit vectors at right angles, right-handed: `u` and `v` in a plane, `w` its normal.
struct PlaneFrame {
    Point3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};

    //! The vector's components along u, v and w: the plane becomes one of constant third component.
    Point3 turned(const Point3& p) const {
        return {p.x * u.x + p.y * u.y + p.z * u.z, p.x * v.x + p.y * v.y + p.z * v.z,
                p.x * w.x + p.y * w.y + p.z * w.z};
    }
};

//! The x, y, z axes turned by the shortest way so that z becomes `normal`; the axes themselves for the zero vector.
//! For a normal straight down, where every way is as short, the turn is about the x axis.
PlaneFrame plane_frame(const Point3& normal);

}  // namespace stratareeb
