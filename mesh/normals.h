// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! How much each face around a vertex says about the vertex normal.
enum class NormalWeight {
    Uniform,  // all the same: the average of the unit normals of the surrounding faces (the 2006 thesis,
              // chapter 2)
    Area,     // by face area: big faces win
    Angle,    // by the angle of the face at the vertex: does not depend on how a flat part is cut into
              // triangles
};

//! Unit normal of each vertex. Triangles without area say nothing. Where the faces cancel each other out, the
//! vertex takes the normal of its first face; a vertex without faces looks up (0, 0, 1).
std::vector<Point3> vertex_normals(const TriangleSoup& soup, NormalWeight weight = NormalWeight::Uniform);

//! Set the vertex normals of a half-edge mesh, by the same rules.
void update_vertex_normals(TriMesh& mesh, NormalWeight weight = NormalWeight::Uniform);

}  // namespace stratareeb
