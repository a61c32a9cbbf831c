// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Each plateau as one node. With ties broken by vertex index, a plateau or a level stretch of ridge may hold several nodes of one
//! value, and which ones depends on the numbering of vertices. Arcs between nodes of equal value shrink to a point here; what
//! has one arc down and one up then is no node. The result is the graph's own, whatever the numbering: pieces of the field's
//! true level sets. Cycles that lie within a plateau are counted in hidden_loops, so that loops() stays. A node's vertex is
//! that of the first of those it was made of; vertices and triangles inside it go with its first arc up, or else down, and
//! with none where a whole component is level.
ReebGraph collapse_plateaus(const ReebGraph& graph);

}  // namespace stratareeb
