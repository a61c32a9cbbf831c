// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

class OGRSpatialReference;

namespace stratareeb {

//! A coordinate reference system by code ("EPSG:27700"), PROJ string or WKT; x east and y north. Null for an empty text.
//! \throw InvalidInput if GDAL doesn't know it
std::shared_ptr<OGRSpatialReference> map_reference(const std::string& crs);

}  // namespace stratareeb
