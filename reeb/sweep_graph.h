// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! Where contours change by more than moving on: at a critical vertex, on a plateau that holds several of them, or where
//! the surface has level triangles.
struct SweepNode {
    std::uint32_t vertex = 0;  // a critical one, or of a level triangle
    double value = 0;
    std::vector<std::uint32_t> down, up;         // edges that end here from below, and that start here
    std::vector<std::uint32_t> level_triangles;  // ascending
    bool is_plateau = false;                     // several critical vertices of one value
};

//! A part of an arc of the Reeb graph.
struct SweepSegment {
    std::uint32_t arc = 0;
    double low = 0, high = 0;
};

struct SweepEdge {
    std::uint32_t lower = 0, upper = 0;  // nodes
    std::vector<SweepSegment>
        segments;  // bottom to top; several where a plateau is passed that changes nothing
};

//! The Reeb graph whose nodes are connected pieces of true level sets, shelves included, by which a contour does not simply move on.
struct SweepGraph {
    std::vector<SweepNode> nodes;  // by value
    std::vector<SweepEdge> edges;  // in the order of their lower nodes
};

//! \pre `graph` is reeb_graph(mesh, field)
//! \throw InvalidInput if a whole component of the surface is level
SweepGraph sweep_graph(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph);

}  // namespace stratareeb
