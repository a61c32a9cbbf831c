// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"

namespace stratareeb {

//! Write a binary STL file of all parts. STL holds single precision: corners move to the nearest float. A
//! triangle two of whose corners fall together there is left out; its neighbours then meet along the closed
//! gap, so a closed mesh stays closed.
//! \throw IoError if it can't be written
void write_stl(const std::filesystem::path& file, std::span<const PartData> parts);

}  // namespace stratareeb
