// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Read an OFF file in text form: OFF, COFF, NOFF, CNOFF and STOFF headers; what follows x y z in a vertex
//! line is skipped, polygons become fans.
//! \throw IoError, InvalidInput as read_mesh does
PartData read_off(const std::filesystem::path& file);

//! The same with the polygons that its triangles were.
PolygonPart read_off_polygons(const std::filesystem::path& file);

}  // namespace stratareeb
