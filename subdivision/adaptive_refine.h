// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subdivision/refine.h"

namespace stratareeb {

struct AdaptiveMesh {
    RefinedMesh refined;  // triangles (Loop), or quads with triangles where sizes meet (Catmull-Clark)
    int levels = 0;       // of the smallest faces
};

//! The limit surface of a mesh in as few faces as it takes: where it is flat, faces stay as large as those of the control mesh;
//! where it curves, they are cut until the surface is no further from them than the tolerance, or `options.levels` deep. Vertices
//! are on the limit surface; neighbouring faces share whole edges, so there are no cracks.
//!
//! How far the surface is from an edge is measured at its middle, along the surface's normal, or across the edge where that is an
//! outline or a crease; what the levels below add is added. An edge that is too far is cut; a face whose edges are all cut is
//! quartered, others take up the middles that they share with those (red-green refinement; Bank, Sherman, Weiser 1983), for
//! Catmull-Clark in a fan around their centre.
//! \param tolerance in the units of the mesh
//! \throw InvalidInput for a tolerance that is not positive; as refine does
AdaptiveMesh adaptive_refine(const PolygonMesh& control, double tolerance, const RefineOptions& options = {});

}  // namespace stratareeb
