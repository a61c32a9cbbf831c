// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "reeb/level_set.h"

namespace stratareeb {

//! Write level sets by the file's extension: .json (a contour stack: `contours`, each with `z` = the level, `closed` and
//! `points` [x, y]) or .obj (one polyline a contour, in space).
//! \throw IoError for another extension, or if the file can't be written
void write_contours(const std::filesystem::path& file, std::span<const LevelSet> sets);

}  // namespace stratareeb
