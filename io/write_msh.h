// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "io/write_vtu.h"
#include "mesh/volume_mesh.h"

namespace stratareeb {

//! Write cells as a gmsh mesh (.msh, version 2.2, text), which most simulators read. Physical groups: a volume for each layer, by its code
//! (number 1 = top layer), and the outer surface as "ground", "base" and "sides" for boundary conditions.
//! \throw IoError if the file can't be written
void write_msh(const std::filesystem::path& file, const VolumeMesh& mesh, const CellRecord& record);

}  // namespace stratareeb
