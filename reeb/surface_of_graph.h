// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/surface_construction.h"

namespace stratareeb {

//! The surface of any enhanced Reeb graph, with flat and open nodes. The graph is taken apart at these; each piece is built by
//! construct_surface. At an open node the surface ends in a boundary loop, the contour there. At a flat one, pieces are joined again along the sides that
//! their contours have in common, and what an odd number of contours lies around is filled with level triangles: a step, a shelf, a floor or a
//! ceiling with holes, or nothing where a level contour just passes several critical points. Contours keep every corner.
//! The surface is closed but for one boundary loop at each open node.
//! \throw InvalidInput if faults_of(graph) finds any, as construct_surface does, or at a flat node whose contours fit no surface: where more
//! than two pieces would meet in one side.
//! \param memory of surfaces of similar graphs; it saves time
ConstructedSurface surface_of_graph(const EnhancedReebGraph& graph, const SurfaceOptions& options = {},
                                    SurfaceMemory* memory = nullptr);

}  // namespace stratareeb
