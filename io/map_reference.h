// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

class OGRSpatialReference;

namespace stratareeb {

//! A coordinate reference system by code ("EPSG:27700"), PROJ string or WKT; x east and y north. Null for an empty text.
//! \throw InvalidInput if GDAL doesn't know it
std::shared_ptr<OGRSpatialReference> map_reference(const std::string& crs);

//! A short name for it: "EPSG:27700" where an authority lists it, else WKT in one line; empty for an empty text.
//! \throw as map_reference
std::string reference_name(const std::string& crs);

//! Do two texts mean the same system?
bool is_same_reference(const std::string& a, const std::string& b);

//! Does it count in degrees?
bool is_in_degrees(const std::string& crs);

}  // namespace stratareeb
