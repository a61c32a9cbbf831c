// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"
#include "mesh/vertical_section.h"

namespace stratareeb {

//! A section as a panel in space: a surface for each layer, upright over the line, seen from the right of it. Layers share the
//! places of their borders. Coordinates are relative to `origin`; a layer that the section does not meet is empty.
std::vector<TriMesh> fence_meshes(const VerticalSection& section, std::size_t layers, const Point3& origin);

}  // namespace stratareeb
