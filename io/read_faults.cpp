// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_faults.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "boreholes/errors.h"
#include "io/feature_geometries.h"

namespace stratareeb {

namespace {

using Traces = std::vector<std::vector<Point2>>;

void add_line(const OGRSimpleCurve& line, Traces& traces) {
    if (line.getNumPoints() < 2) return;
    auto& trace = traces.emplace_back();
    for (int i = 0; i < line.getNumPoints(); ++i) trace.push_back({line.getX(i), line.getY(i)});
}

void add_lines(const OGRGeometry& geometry, Traces& traces) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbLineString:
            return add_line(*geometry.toLineString(), traces);
        case wkbPolygon:
            for (const OGRLinearRing* ring : *geometry.toPolygon()) add_line(*ring, traces);
            return;
        case wkbMultiLineString:
        case wkbMultiPolygon:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_lines(*part, traces);
            return;
        default:
            return;
    }
}

}  // namespace

std::vector<std::vector<Point2>> read_faults(const std::string& path) {
    Traces traces;
    for_each_geometry(path, "lines", [&](const OGRGeometry& geometry) { add_lines(geometry, traces); });
    if (traces.empty())
        throw InvalidInput(
            path + ": no line in it; fault traces are lines (in a CSV table, a column WKT holds them)");
    return traces;
}

}  // namespace stratareeb
