// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Rings of the model's outline in plan: the outer ring first, counter-clockwise, then holes, clockwise; the
//! first point is not repeated at the end. From a table of x, y (text or spreadsheet; one ring, in order), or
//! the polygons or closed lines of any OGR source (GeoPackage, shapefile, GeoJSON, …); of several polygons
//! the largest counts.
//! \throw IoError if it can't be opened; InvalidInput if it has no ring with an area, or
//! a ring crosses itself or another.
std::vector<std::vector<Point2>> read_footprint(const std::string& path);

}  // namespace stratareeb
