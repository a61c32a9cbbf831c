// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Several arcs of a Reeb graph in a row, from node to node of the core.
struct CoreArc {
    std::uint32_t lower = 0, upper = 0;  // indices into LoopCore::nodes
    std::vector<std::uint32_t> arcs;     // of the graph, bottom to top
};

//! What is left of a graph when its branches without loops are taken away: each node lies on a cycle or between two. Nodes
//! with one arc down and one arc up in the core lie inside core arcs. Empty without loops.
struct LoopCore {
    std::vector<std::uint32_t> nodes;  // of the graph, bottom to top
    std::vector<CoreArc> arcs;         // by upper node
};

//! Takes linear time.
LoopCore loop_core(const ReebGraph& graph);

}  // namespace stratareeb
