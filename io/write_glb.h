// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"

namespace stratareeb {

//! Write a GLB (binary glTF 2.0) file: one named node, mesh and material a part, y up as glTF wants it, back
//! faces not drawn. Coordinates are floats around the middle of the box; a root node turns z up and moves
//! them back.
//! \throw IoError if it can't be written
void write_glb(const std::filesystem::path& file, std::span<const PartData> parts);

}  // namespace stratareeb
