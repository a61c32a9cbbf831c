// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/mesh_part.h"
#include "io/polygon_fan.h"

namespace stratareeb {

//! Write an OFF file in text form with all parts, one after another, and a colour per face; coordinates keep
//! every bit.
//! \throw IoError if it can't be written
void write_off(const std::filesystem::path& file, std::span<const PartData> parts);

//! The same for one part whose polygons stay whole.
void write_off_polygons(const std::filesystem::path& file, const PolygonPart& polygons);

}  // namespace stratareeb
