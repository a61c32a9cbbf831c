// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Indexed triangles as a file gives them: any mesh, sound or not. A half-edge TriMesh can't hold non-manifold edges;
//! this can, so that a report can name them.
struct TriangleSoup {
    std::vector<Point3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace stratareeb
