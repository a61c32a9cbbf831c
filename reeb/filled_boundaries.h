// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! The mesh with each of its boundary loops filled by level triangles. Vertices keep their numbers; triangles that fill come last.
//! \throw InvalidInput where a loop is not level or crosses itself in plan, as that of a terrain: the message names it and the way out.
TriMesh filled_boundaries(const TriMesh& mesh);

}  // namespace stratareeb
