// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "io/mesh_part.h"

namespace stratareeb {

//! Read a GLB file: the triangles of all nodes of the scene, transformed, one part for each node with a mesh;
//! y up is turned z up. Vertices of a part are welded where they are exactly equal, since glTF repeats them
//! along sharp edges. The colour is the base colour of the first material. Buffers outside the file and
//! compressed meshes are refused.
//! \throw IoError, InvalidInput as read_mesh does
std::vector<PartData> read_glb(const std::filesystem::path& file);

}  // namespace stratareeb
