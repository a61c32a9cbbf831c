// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A point, a line or an area for GIS and CAD.
struct MapFeature {
    enum class Kind { Point, Line, Polygon };
    Kind kind = Kind::Line;
    //! One list for a point or line; outer ring first, then holes, for a polygon; rings without a repeated last point.
    std::vector<std::vector<Point3>> parts;
    std::string layer;  // CAD layer, and an attribute of this name
    std::string color;  // "#rrggbb"
    std::vector<std::pair<std::string, std::variant<double, std::string>>>
        attributes;  // the same names for all
};

struct FeatureFileOptions {
    std::string table = "features";  // name of the table in a GeoPackage
    std::string crs = {};            // "EPSG:27700", WKT, PROJ, …; empty = none stated
    bool flat = true;                // 2D geometry; else z is kept
};

//! Write features by extension: .gpkg (GeoPackage), .dxf (AutoCAD DXF, layers in their colours), .geojson. A file that
//! is there is replaced once the new one is whole.
//! \throw IoError for another extension or if the file can't be written; InvalidInput for an unknown CRS
void write_features(const std::filesystem::path& file, const std::vector<MapFeature>& features,
                    const FeatureFileOptions& options = {});

//! Does the extension stand for such a file?
bool is_feature_file(const std::filesystem::path& file);

}  // namespace stratareeb
