// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! The closed body (or bodies) of one layer. Vertices stand in the local frame of the model; add its origin for map
//! coordinates. A layer that is absent everywhere has an empty surface.
struct LayerSolid {
    std::size_t order = 0;  // 1 = top layer
    std::size_t block = 0;  // 1 = first block of a faulted model; 0 = all, or no faults
    Unit unit;
    TriMesh surface;  // closed, 2-manifold, outward, vertex normals set
};

}  // namespace stratareeb
