// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_footprint.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/quiet_gdal.h"
#include "io/read_table.h"
#include "io/table_layout.h"

namespace stratareeb {
namespace {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

double signed_area(const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {  // about the first point: far coordinates cancel
        const Point2 &o = ring[0], &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    }
    return 0.5 * twice;
}

//! Without the closing point and points that repeat their neighbour.
Ring open_ring(const Ring& points) {
    Ring ring;
    for (const Point2& point : points)
        if (ring.empty() || ring.back() != point) ring.push_back(point);
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_between(const Point2& a, const Point2& b, const Point2& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool segments_meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double t1 = turn(a, b, c), t2 = turn(a, b, d), t3 = turn(c, d, a), t4 = turn(c, d, b);
    if (((t1 > 0 && t2 < 0) || (t1 < 0 && t2 > 0)) && ((t3 > 0 && t4 < 0) || (t3 < 0 && t4 > 0))) return true;
    return (t1 == 0 && is_between(a, b, c)) || (t2 == 0 && is_between(a, b, d)) ||
           (t3 == 0 && is_between(c, d, a)) || (t4 == 0 && is_between(c, d, b));
}

struct Edge {
    Point2 a, b;
    std::size_t ring = 0, place = 0, of = 0;  // its number in the ring, and how many the ring has
};

bool are_neighbours(const Edge& p, const Edge& q) {
    if (p.ring != q.ring) return false;
    return (p.place + 1) % p.of == q.place || (q.place + 1) % q.of == p.place;
}

//! Two edges that share a point run back over each other.
bool folds_back(const Edge& p, const Edge& q) {
    const Point2& shared = (p.b == q.a) ? p.b : p.a;
    const Point2 &u = p.b == shared ? p.a : p.b, &v = q.a == shared ? q.b : q.a;
    return turn(shared, u, v) == 0 &&
           (u.x - shared.x) * (v.x - shared.x) + (u.y - shared.y) * (v.y - shared.y) > 0;
}

void check_crossings(const Rings& rings, const std::string& path) {
    std::vector<Edge> edges;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].size(); ++i)
            edges.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()], r, i, rings[r].size()});
    const auto left = [](const Edge& e) { return std::min(e.a.x, e.b.x); };
    std::sort(edges.begin(), edges.end(), [&](const Edge& p, const Edge& q) { return left(p) < left(q); });
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1;
             j < edges.size() && left(edges[j]) <= std::max(edges[i].a.x, edges[i].b.x); ++j) {
            const Edge &p = edges[i], &q = edges[j];
            if (are_neighbours(p, q) ? folds_back(p, q) : segments_meet(p.a, p.b, q.a, q.b))
                throw InvalidInput(fmt::format("{}: the outline meets itself near x {}, y {}; mend it there",
                                               path, q.a.x, q.a.y));
        }
}

Rings checked(Rings rings, const std::string& path) {
    for (Ring& ring : rings) ring = open_ring(ring);
    std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3 || signed_area(ring) == 0; });
    if (rings.empty())
        throw InvalidInput(path + ": no outline with an area in it; a footprint needs at least 3 points");
    for (std::size_t i = 0; i < rings.size(); ++i)
        if ((signed_area(rings[i]) > 0) != (i == 0)) std::reverse(rings[i].begin(), rings[i].end());
    check_crossings(rings, path);
    return rings;
}

Ring ring_of(const OGRLineString& line) {
    Ring ring;
    for (int i = 0; i < line.getNumPoints(); ++i) ring.push_back({line.getX(i), line.getY(i)});
    return ring;
}

Rings rings_of(const OGRPolygon& polygon) {
    Rings rings;
    if (!polygon.getExteriorRing()) return rings;
    rings.push_back(ring_of(*polygon.getExteriorRing()));
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
        rings.push_back(ring_of(*polygon.getInteriorRing(i)));
    return rings;
}

void keep_larger(Rings& best, Rings other) {
    const auto area = [](const Rings& rings) {
        return rings.empty() || rings[0].empty() ? -1 : std::abs(signed_area(rings[0]));
    };
    if (area(other) > area(best)) best = std::move(other);
}

void take_largest(const OGRGeometry& geometry, Rings& best) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPolygon:
            return keep_larger(best, rings_of(*geometry.toPolygon()));
        case wkbLineString:
            if (geometry.toLineString()->get_IsClosed())
                keep_larger(best, {ring_of(*geometry.toLineString())});
            return;
        case wkbMultiPolygon:
        case wkbMultiLineString:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) take_largest(*part, best);
            return;
        default:
            return;
    }
}

Rings polygons_of(GDALDataset& dataset) {
    Rings best;
    for (int i = 0; i < dataset.GetLayerCount(); ++i) {
        OGRLayer& layer = *dataset.GetLayer(i);
        layer.ResetReading();
        while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()})
            if (const OGRGeometry* geometry = feature->GetGeometryRef()) {
                const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry());
                take_largest(*linear, best);
            }
    }
    return best;
}

Rings rings_of_table(const std::string& path) {
    const TextTable table = std::move(read_tables(path).front());
    const TableShape shape = table_shape(table, {});
    std::size_t x = 0, y = 1;
    if (shape.has_header) {
        x = find_column(shape, Role::X).value_or(0);
        y = find_column(shape, Role::Y).value_or(1);
    }
    Ring ring;
    for (std::size_t row = shape.first_row; row < table.row_count(); ++row) {
        const CellValue a = cell_value(table.cell(row, x), table.decimal_comma),
                        b = cell_value(table.cell(row, y), table.decimal_comma);
        if (a.kind == CellKind::Empty && b.kind == CellKind::Empty) continue;
        if (a.kind != CellKind::Number || b.kind != CellKind::Number)
            throw InvalidInput(fmt::format("{}:{}: x, y expected, \"{}\", \"{}\" found", path,
                                           table.line(row), table.cell(row, x), table.cell(row, y)));
        ring.push_back({a.number, b.number});
    }
    return {ring};
}

bool is_table_file(const std::string& path) {
    constexpr std::array<const char*, 8> kTables{".csv", ".txt",  ".tsv", ".dat",
                                                 ".xyz", ".xlsx", ".xls", ".ods"};
    return std::any_of(kTables.begin(), kTables.end(),
                       [&](const char* extension) { return path.ends_with(extension); });
}

}  // namespace

std::vector<std::vector<Point2>> read_footprint(const std::string& path) {
    if (is_table_file(path)) return checked(rings_of_table(path), path);
    GDALAllRegister();
    const QuietErrors quiet;
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset) throw IoError(fmt::format("{}: not a file of polygons that can be opened", path));
    return checked(polygons_of(*dataset), path);
}

}  // namespace stratareeb
