// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_areas.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <memory>

#include "boreholes/errors.h"
#include "io/feature_geometries.h"
#include "io/quiet_gdal.h"
#include "io/read_footprint.h"
#include "mesh/ring_stitching.h"

namespace stratareeb {

namespace {

using Rings = std::vector<std::vector<Point2>>;

void add_polygon(const OGRPolygon& polygon, OGRMultiPolygon& all, const std::string& path) {
    if (polygon.IsEmpty()) return;
    if (!polygon.IsValid())
        throw InvalidInput(fmt::format("{}: a polygon near x {}, y {} is not valid: {}", path,
                                       polygon.getExteriorRing()->getX(0), polygon.getExteriorRing()->getY(0),
                                       CPLGetLastErrorMsg()));
    all.addGeometry(&polygon);
}

void add_parts(const OGRGeometry& geometry, OGRMultiPolygon& all, const std::string& path) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPolygon:
            return add_polygon(*geometry.toPolygon(), all, path);
        case wkbLineString:
            if (geometry.toLineString()->get_IsClosed()) {
                OGRLinearRing ring;
                ring.addSubLineString(geometry.toLineString());
                OGRPolygon polygon;
                polygon.addRing(&ring);
                add_polygon(polygon, all, path);
            }
            return;
        case wkbMultiPolygon:
        case wkbMultiLineString:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_parts(*part, all, path);
            return;
        default:
            return;
    }
}

void add_ring(const OGRLinearRing& line, bool outer, Rings& rings) {
    std::vector<Point2> ring;
    for (int i = 0; i + 1 < line.getNumPoints(); ++i) ring.push_back({line.getX(i), line.getY(i)});
    if ((ring_area(ring) > 0) != outer) std::ranges::reverse(ring);
    rings.push_back(std::move(ring));
}

Rings rings_of(const OGRGeometry& geometry) {
    Rings rings;
    if (wkbFlatten(geometry.getGeometryType()) == wkbPolygon) {
        const OGRPolygon& polygon = *geometry.toPolygon();
        if (polygon.IsEmpty()) return rings;
        add_ring(*polygon.getExteriorRing(), true, rings);
        for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
            add_ring(*polygon.getInteriorRing(i), false, rings);
    } else if (OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbGeometryCollection)) {
        for (const OGRGeometry* part : *geometry.toGeometryCollection())
            for (auto& ring : rings_of(*part)) rings.push_back(std::move(ring));
    }
    return rings;
}

bool is_table_file(const std::string& path) {
    constexpr std::array kTables{".csv", ".txt", ".tsv", ".dat", ".xyz", ".xlsx", ".xls", ".ods"};
    return std::ranges::any_of(kTables, [&](const char* extension) { return path.ends_with(extension); });
}

}  // namespace

std::vector<std::vector<Point2>> read_areas(const std::string& path) {
    if (is_table_file(path)) return read_footprint(path);
    const QuietErrors quiet;
    OGRMultiPolygon all;
    for_each_geometry(path, "polygons", [&](OGRGeometry& geometry) {
        geometry.flattenTo2D();
        add_parts(geometry, all, path);
    });
    if (all.IsEmpty()) throw InvalidInput(path + ": no polygon in it");
    const std::unique_ptr<OGRGeometry> dissolved(all.UnionCascaded());
    if (!dissolved) throw InvalidInput(fmt::format("{}: {}", path, CPLGetLastErrorMsg()));
    Rings rings = rings_of(*dissolved);
    if (rings.empty()) throw InvalidInput(path + ": no polygon with an area in it");
    return rings;
}

}  // namespace stratareeb
