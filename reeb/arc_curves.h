// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/point.h"
#include "reeb/arc_index.h"

namespace stratareeb {

//! The centre of a contour: the centroid of its line, each piece weighing its length; of a point the point.
//! \pre the contour has a point
Point3 center_of(const Contour& contour);

//! The Reeb graph in space: one polyline an arc, from the vertex of its lower node through the centres of `samples` of its
//! contours, evenly apart in value, to the vertex of its upper node. Arcs between nodes of equal value are straight.
//! The work of it is the contours' lengths, on all threads.
//! \pre `graph` is reeb_graph(mesh, field), and the index is its own
std::vector<std::vector<Point3>> arc_curves(const TriMesh& mesh, const ReebGraph& graph,
                                            const ArcIndex& index, std::size_t samples = 8);

}  // namespace stratareeb
