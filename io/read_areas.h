// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! All polygons (and closed lines) of an OGR source (GeoPackage, shapefile, GeoJSON, …), holes and parts included, dissolved
//! where they overlap or touch; or one ring of x, y from a table. Outer rings counter-clockwise, holes clockwise, the first
//! point not repeated.
//! \throw IoError if it can't be opened; InvalidInput if there is no area, or a polygon is not valid
std::vector<std::vector<Point2>> read_areas(const std::string& path);

}  // namespace stratareeb
