// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

//! What keeps a graph from being an enhanced Reeb graph (thesis 2.1.1.3.2), one line a fault, each with the names of nodes,
//! edges and contours and the numbers that are wrong; none if it is sound:
//! - names are unique; every edge joins two different nodes, has contours, and every contour is on just one edge;
//! - an edge's curve rises all the way from its lower node to its upper one, as a curve, not only in its control points;
//! - contours are planar, simple closed curves, all counter-clockwise seen from above;
//! - they stand in order of height between their edge's nodes. One at the height of a node passes through it, or closes the surface flat there if
//!   the node has no other edge;
//! - no two contours meet, nor does one touch itself, but in a node that they pass through, and in corners or along whole sides at a
//!   flat one;
//! - contours next to a flat or open node stand at its very height, and an open one has one edge.
//! Splines are judged by polygons on them.
std::vector<std::string> faults_of(const EnhancedReebGraph& graph);

//! \throw InvalidInput with all faults, if there are any.
void check_graph(const EnhancedReebGraph& graph);

}  // namespace stratareeb
