// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "reeb/arc_index.h"

namespace stratareeb {

//! Which arcs of a Reeb graph make up each arc of one with plateaus collapsed or simplified: those that share triangles (or, where an
//! arc has none, vertices). Arcs are ascending in each list.
struct ArcMembers {
    std::vector<std::vector<std::uint32_t>> fine_of;    // of each coarse arc
    std::vector<std::vector<std::uint32_t>> coarse_of;  // of each fine arc; empty for what shrank to a node
};

//! \pre both graphs are of the same mesh and field
ArcMembers arc_members(const ReebGraph& fine, const ReebGraph& coarse);

//! arc_curves for a coarser graph. Where an arc has several contours at a height, the curve goes through the centre of the longest.
//! Arcs that span little of the field's range have fewer samples, down to one, in graphs of thousands of arcs none.
//! \pre `fine` is reeb_graph(mesh, field), the index is its own, and `members` is arc_members(fine, coarse)
std::vector<std::vector<Point3>> coarse_arc_curves(const TriMesh& mesh, const ReebGraph& fine,
                                                   const ArcIndex& index, const ReebGraph& coarse,
                                                   const ArcMembers& members, std::size_t samples = 8);

}  // namespace stratareeb
