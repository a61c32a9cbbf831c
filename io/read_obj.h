// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Read an OBJ file: one part for each object ("o" line) that has faces, with the vertices it uses; relative
//! indices, texture and normal indices, polygons as fans. Part colours come from the diffuse colours of the
//! MTL file.
//! \throw IoError, InvalidInput as read_mesh does
std::vector<PartData> read_obj(const std::filesystem::path& file);

//! The same with the polygons that its triangles were.
std::vector<PolygonPart> read_obj_polygons(const std::filesystem::path& file);

}  // namespace stratareeb
