// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/persistence.h"

namespace stratareeb {

//! Where a loop of the Reeb graph is on the mesh.
struct LoopHandle {
    LoopCycle cycle;
    std::vector<std::uint32_t> triangles;  // of the cycle's side with fewer of them, ascending
    Point3 box_min, box_max;               // around these; around the pair's two vertices if there are none
};

//! The handles of a graph's loops, in the order of loop_cycles. A handle is the side of the cycle that has fewer triangles (but
//! some, if the other has); branches that leave the cycle are no part of it. Time: that of loop_cycles and the number of triangles returned.
std::vector<LoopHandle> loop_handles(const TriMesh& mesh, const ReebGraph& graph);

}  // namespace stratareeb
