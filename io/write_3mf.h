// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"

namespace stratareeb {

//! Write a 3MF file: one object with name and colour a part, all placed by the build. Coordinates are floats
//! around the middle of the box, moved back by the build; the unit is the metre.
//! \throw IoError if it can't
//! be written
void write_3mf(const std::filesystem::path& file, std::span<const PartData> parts);

}  // namespace stratareeb
