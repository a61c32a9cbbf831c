// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "boreholes/point.h"
#include "reeb/curve.h"
#include "reeb/homotopy_weights.h"

namespace stratareeb {

//! A name in a graph file: a whole number or a text.
using GraphId = std::variant<std::int64_t, std::string>;
std::string text_of(const GraphId& id);

//! What the surface is like at a node.
enum class NodeForm {
    Point,  // a critical point
    Flat,  // level: its edges' contours stand at its very height, and what an odd number of them lies around is the surface's
    Open,  // the surface ends in the one contour there
};

struct EnhancedNode {
    GraphId id;
    Point3 position;  // of the critical point; in Flat and Open ones any place of that height
    NodeForm form = NodeForm::Point;

    friend bool operator==(const EnhancedNode&, const EnhancedNode&) = default;
};

struct EnhancedContour {
    GraphId id;
    Curve curve;  // closed

    friend bool operator==(const EnhancedContour&, const EnhancedContour&) = default;
};

//! A family of contours that rises from one node to another without merging or splitting.
struct EnhancedEdge {
    std::uint32_t from = 0, to = 0;       // nodes, the lower first
    Curve curve;                          // through these points between the nodes; a straight line has none
    std::vector<std::uint32_t> contours;  // bottom to top
    HomotopyOptions homotopy;

    friend bool operator==(const EnhancedEdge&, const EnhancedEdge&) = default;
};

//! The Reeb graph of a height function with geometry, from which its surface can be built (thesis 2.1.1.3.2): nodes in space,
//! edges as curves that rise all the way, and contours as closed curves.
struct EnhancedReebGraph {
    std::vector<EnhancedNode> nodes;
    std::vector<EnhancedContour> contours;
    std::vector<EnhancedEdge> edges;

    friend bool operator==(const EnhancedReebGraph&, const EnhancedReebGraph&) = default;
};

//! Does the graph have nodes that are no critical points?
bool has_level_nodes(const EnhancedReebGraph& graph);

//! An edge's whole curve, from node to node.
Curve curve_of(const EnhancedReebGraph& graph, const EnhancedEdge& edge);

//! Independent cycles: edges - nodes + components.
std::size_t loops_of(const EnhancedReebGraph& graph);

}  // namespace stratareeb
