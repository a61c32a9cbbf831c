// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "io/mesh_part.h"

namespace stratareeb {

//! Read an STL file, ASCII or binary. Corners are welded where their coordinates are exactly equal.
//! \throw IoError, InvalidInput as read_mesh does
PartData read_stl(const std::filesystem::path& file);

}  // namespace stratareeb
