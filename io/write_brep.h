// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "io/cad_body.h"

namespace stratareeb {

//! Write bodies as one compound in OpenCASCADE's own format (.brep): no names, colours or units, and faces that
//! neighbours share are in it once. Bodies come from faceted_bodies or smooth_bodies. The file appears whole or not
//! at all.
//! \throw InvalidInput if there is no body; IoError if the file can't be written.
void write_brep(const std::filesystem::path& path, std::span<const CadBody> bodies);

}  // namespace stratareeb
