// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! How a surface is seen from the side: `right` and `toward` (the eye) are unit vectors, square to the direction of height and to
//! each other. Right is the way the surface reaches farthest in, so that it shows its broad side.
struct SideView {
    Point3 right, toward;
    double right_min = 0, right_max = 0, toward_min = 0, toward_max = 0;  // what the mesh covers

    double across(const Point3& p) const { return right.x * p.x + right.y * p.y + right.z * p.z; }
    double depth(const Point3& p) const { return toward.x * p.x + toward.y * p.y + toward.z * p.z; }
};

//! The view with `up` as the direction of height, z if there is none. \pre up is not zero
SideView side_view(const TriMesh& mesh, const std::optional<Point3>& up);

}  // namespace stratareeb
