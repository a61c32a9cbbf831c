// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Fault traces in plan: all lines of any OGR source (GeoJSON, GeoPackage, DXF, shapefile, a CSV table with a WKT column); of
//! polygons, their outlines. Other geometries are left alone; so are third coordinates.
//! \throw IoError if it can't be opened; InvalidInput if there is no line in it
std::vector<std::vector<Point2>> read_faults(const std::string& path);

}  // namespace stratareeb
