// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Where a graph's arcs and nodes stand beside each other when values are drawn upwards: arcs that pass a value together are at
//! least 1 apart there.
struct GraphColumns {
    std::vector<double> arc_x, node_x;
    double width = 0;  // all x are in 0 … width
};

//! Columns for a drawing with few crossings. The nodes are swept from bottom to top, with a list of the arcs that pass from left to
//! right: arcs that leave a node take the place of those that end there, a minimum's arc comes in beside those it will meet.
//! The list's order at all values together is one without cycles, so that columns are found from left and from right, then
//! drawn towards the nodes. Trees that only join or only split upwards have no crossings.
//! \param preferred x of each arc, any scale: which goes left, where the graph leaves that open
GraphColumns graph_columns(const ReebGraph& graph, std::span<const double> preferred);

}  // namespace stratareeb
