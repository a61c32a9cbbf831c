// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Cut a mesh into its connected components (joined by shared vertices), in the order of their first
//! triangles; vertices and triangles keep their order. Unused vertices are left out.
std::vector<TriangleSoup> connected_components(const TriangleSoup& soup);

//! The same for a half-edge mesh; vertex normals come along.
std::vector<TriMesh> connected_components(const TriMesh& mesh);

}  // namespace stratareeb
