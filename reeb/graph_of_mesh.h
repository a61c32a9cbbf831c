// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/tri_mesh.h"
#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

struct MeshGraphOptions {
    std::size_t levels =
        20;  // even levels over the whole height; an arc that none of them crosses gets one of its own
    double tolerance =
        0;  // > 0: further levels on an arc until a contour half way between two is no farther than this from what
    // the homotopy makes there
    std::size_t most_per_arc = 200;  // contours that tolerance may ask for
    HomotopyKind homotopy = HomotopyKind::Cardinal;
    std::size_t crossing_rounds =
        4;  // times that the surface is made to see where it crosses itself and wants contours between
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
