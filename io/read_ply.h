// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Read a PLY file: ASCII or binary of either byte order; properties in any order and of any type, unknown
//! ones skipped; polygons as fans. A colour that all vertices share becomes the colour of the part.
//! \throw IoError, InvalidInput as read_mesh does
PartData read_ply(const std::filesystem::path& file);

//! The same with the polygons that its triangles were.
PolygonPart read_ply_polygons(const std::filesystem::path& file);

//! One number a vertex, as a PLY file holds beside the coordinates: MeshLab's `quality`, a colour's `red`.
//! \throw InvalidInput naming the properties that are there, if this one is not; IoError, InvalidInput as read_mesh does
std::vector<double> read_ply_property(const std::filesystem::path& file, const std::string& property);

}  // namespace stratareeb
