// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/map_reference.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "boreholes/errors.h"
#include "io/quiet_gdal.h"

namespace stratareeb {

std::shared_ptr<OGRSpatialReference> map_reference(const std::string& crs) {
    if (crs.empty()) return nullptr;
    const QuietErrors quiet;
    auto result = std::make_shared<OGRSpatialReference>();
    if (result->SetFromUserInput(crs.c_str()) != OGRERR_NONE)
        throw InvalidInput(fmt::format(
            "unknown coordinate reference system '{}'; give a code such as EPSG:27700, a PROJ string or WKT",
            crs));
    result->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return result;
}

}  // namespace stratareeb
