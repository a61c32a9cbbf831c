// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

//! An edge's end at a flat or open node.
struct LevelEnd {
    std::uint32_t node = 0, edge = 0;
    bool is_top = false;
    std::vector<Point3> points;  // of the contour there
    std::vector<Point3>
        apart;  // the same, but where a corner comes more than once its visits are drawn apart a little
};

//! A graph taken apart at its flat and open nodes: each of their edges ends at a node of its own there, which closes its contour
//! flat. Edges keep their numbers.
struct LevelPieces {
    EnhancedReebGraph graph;
    std::vector<LevelEnd> ends;     // by node, then as edges are numbered, those from below first
    std::vector<bool> turned;       // by edge: seen alone, its piece would face the wrong way
    bool has_pinched_ends = false;  // contours with a corner that comes more than once
};

//! \param samples points on a contour that is no polygon
//! \pre faults_of(graph) is empty
//! \throw InvalidInput if a contour has one side twice, or no room to be drawn apart
LevelPieces level_pieces(const EnhancedReebGraph& graph, std::size_t samples);

//! Can contours of one height meet at a flat node: no two sides cross, none is on more than two of them, and each contour can be drawn
//! apart where it touches itself?
bool fit_at_level_node(const std::vector<std::vector<Point3>>& contours);

}  // namespace stratareeb
