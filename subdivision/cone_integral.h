// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/point.h"

namespace stratareeb {

//! What a face adds to a volume that is measured from a point, and the integral of its normals, on which it depends how that
//! changes with the point. Those of all faces of a solid add up to nothing, but for mistakes of integration.
struct ConeIntegral {
    double cone = 0;
    Point3 normal;

    //! What the cone grows by when it is measured from a point that lies `by` further on.
    double growth(const Point3& by) const {
        return -(by.x * normal.x + by.y * normal.y + by.z * normal.z) / 3;
    }

    ConeIntegral& add(const ConeIntegral& other, double times = 1) {
        cone += times * other.cone;
        normal = {normal.x + times * other.normal.x, normal.y + times * other.normal.y,
                  normal.z + times * other.normal.z};
        return *this;
    }
};

}  // namespace stratareeb
