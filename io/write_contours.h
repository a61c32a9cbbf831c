// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "reeb/level_set.h"

namespace stratareeb {

//! Write level sets by the file's extension: .json (a contour stack) or .obj (one polyline a contour, in space).
//! The stack has `contours`, each with `z` = the level, `closed` and `points`. Levels of the height z have points [x, y].
//! Those of any other field have points [x, y, z], since their level does not say where they lie, and the stack begins with
//! `direction` [dx, dy, dz] if the field is the height along one. Contours of a height, along z or another direction, also
//! have `depth` (how many closed ones of the same level lie around it) and `parent` (the place in `contours`, from 0, of the
//! innermost of those, or null).
//! \param direction of the height that the levels are of; none for another field
//! \throw IoError for another extension, or if the file can't be written
void write_contours(const std::filesystem::path& file, std::span<const LevelSet> sets,
                    const std::optional<Point3>& direction = Point3{0, 0, 1});

}  // namespace stratareeb
