// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Write an OBJ file with one object, group and material a part, and the MTL file of the same stem beside it.
//! Coordinates keep every bit. Blanks in names become underscores.
//! \throw IoError if it can't be written
void write_obj(const std::filesystem::path& file, std::span<const PartData> parts);

//! The same for one part whose polygons stay whole.
void write_obj_polygons(const std::filesystem::path& file, const PolygonPart& polygons);

}  // namespace stratareeb
