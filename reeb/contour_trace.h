// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/tri_mesh.h"
#include "reeb/level_set.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! Follow one contour from an edge that it crosses, with higher values on its left, until it is back or ends on the boundary.
//! `start` is the edge's half-edge that leads from above the level (or at it) to below; an open contour must start on the
//! boundary.
Contour trace_contour(const TriMesh& mesh, const ScalarField& field, double level,
                      TriMesh::HalfedgeHandle start);

}  // namespace stratareeb
