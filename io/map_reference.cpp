// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/map_reference.h"

#include <cpl_conv.h>
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

std::string reference_name(const std::string& crs) {
    const auto reference = map_reference(crs);
    if (!reference) return "";
    const char *authority = reference->GetAuthorityName(nullptr),
               *code = reference->GetAuthorityCode(nullptr);
    if (authority != nullptr && code != nullptr) return fmt::format("{}:{}", authority, code);
    char* text = nullptr;
    const bool is_written = reference->exportToWkt(&text) == OGRERR_NONE;
    std::string wkt = is_written && text != nullptr ? text : crs;
    CPLFree(text);
    return wkt;
}

bool is_same_reference(const std::string& a, const std::string& b) {
    const auto first = map_reference(a), second = map_reference(b);
    return !first || !second ? first == second : first->IsSame(second.get()) != 0;
}

bool is_in_degrees(const std::string& crs) {
    const auto reference = map_reference(crs);
    return reference && reference->IsGeographic() != 0;
}

}  // namespace stratareeb
