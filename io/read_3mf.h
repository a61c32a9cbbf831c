// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "io/mesh_part.h"

namespace stratareeb {

//! Read a 3MF file: one part for each mesh object of the build, transformed.
//! \throw IoError, InvalidInput as read_mesh does
std::vector<PartData> read_3mf(const std::filesystem::path& file);

}  // namespace stratareeb
