// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Write a PLY file: binary little-endian; per vertex double x y z, double nx ny nz, uchar red green blue
//! (the part it belongs to); per face a uchar count and int vertex indices. All parts one after another.
//! \throw IoError if it can't be written
void write_ply(const std::filesystem::path& file, std::span<const PartData> parts);

//! The same for one part whose polygons stay whole.
void write_ply_polygons(const std::filesystem::path& file, const PolygonPart& polygons);

}  // namespace stratareeb
