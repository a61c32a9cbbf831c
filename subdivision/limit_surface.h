// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"
#include "subdivision/control_topology.h"
#include "subdivision/refine.h"

namespace stratareeb {

//! The creases and corners that these options ask for in a mesh.
struct SharpFeatures {
    std::vector<Crease> creases;  // outlines not counted
    std::vector<SharpCorner> corners;
};

//! \throw InvalidInput if a face is no polygon or names a vertex that is not there
SharpFeatures sharp_features(const PolygonMesh& control, const RefineOptions& options);

//! A mesh with these features, refined.
ControlTopology refined_topology(const PolygonMesh& control, const SharpFeatures& features,
                                 const RefineOptions& options, LimitsWanted limits);

//! The mesh of the last level, quads cut where their diagonals are shorter if fanned. Vertices are not on the limit surface yet.
PolygonMesh refined_mesh(const ControlTopology& topology, const PolygonMesh& control);

//! Limit points and normals at the vertices of the last level, from that level's mesh. On creases and corners, where the surface has
//! no normal, the mean of those of the faces around.
LimitSurface shaded_limit(const ControlTopology& topology, const PolygonMesh& refined);

}  // namespace stratareeb
