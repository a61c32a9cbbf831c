// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/tri_mesh.h"
#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

struct MeshGraphOptions {
    std::size_t levels =
        20;  // even levels over the whole height, with more beside nodes (see graded_levels); an arc without any gets one of its own
    // > 0: further levels where the surface made of the graph is farther from the mesh than this, or the mesh from it, caps and
    // what is beside saddles included, as long as there is room for contours (a thousandth of an edge's height)
    double tolerance = 0;
    std::size_t most_per_arc = 200;  // contours that tolerance may ask for
    HomotopyKind homotopy = HomotopyKind::Cardinal;
    std::size_t crossing_rounds =
        8;  // times that the surface is made to see where it crosses itself and wants contours between
};

//! The enhanced Reeb graph of a surface over height z: nodes at its critical points, contours at levels of each arc, edges through
//! their centres. Where contours meet in a saddle, those of the side that has more of them are given at its very height,
//! through it. Where the surface is level, or a level contour passes several critical points, the node is flat and all contours next to it
//! are given at its height; shelves on which no contour merges or splits are such nodes too. Level boundary loops at the ends of tubes become
//! open nodes. Small parts by which a contour crosses itself are cut off. From there on the graph stands for itself:
//! reeb/surface_of_graph makes a surface of it.
//! \throw InvalidInput, naming the place and the way out: if a boundary is not level or not the end of a tube, a whole component is level, or
//! the mesh crosses itself so that contours do.
EnhancedReebGraph graph_of_mesh(const TriMesh& mesh, const MeshGraphOptions& options = {});

}  // namespace stratareeb
