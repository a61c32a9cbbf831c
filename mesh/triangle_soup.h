// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! Indexed triangles as a file gives them: any mesh, sound or not. A half-edge TriMesh can't hold
//! non-manifold edges; this can, so that a report can name them.
struct TriangleSoup {
    std::vector<Point3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

//! The triangles of a half-edge mesh. Deleted elements are left out; the order of the others is kept, so the
//! indices are those of the mesh if nothing was deleted.
TriangleSoup triangle_soup(const TriMesh& mesh);

//! The half-edge mesh of sound triangles: every edge has one or two of them, wound the same way, and every
//! vertex one fan of them. Vertex and face indices stay as they are; normals are zero.
//! \throw InvalidInput
//! naming the first triangle, edge or vertex where that does not hold.
TriMesh half_edge_mesh(const TriangleSoup& soup);

}  // namespace stratareeb
