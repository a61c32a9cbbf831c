// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_features.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "boreholes/errors.h"
#include "io/map_reference.h"
#include "io/quiet_gdal.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

using Dataset = std::unique_ptr<GDALDataset, decltype(&GDALClose)>;

const char* driver_of(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".gpkg") return "GPKG";
    if (extension == ".dxf") return "DXF";
    if (extension == ".geojson") return "GeoJSON";
    return nullptr;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw IoError(fmt::format("{}: can't be written: {}", file.string(), CPLGetLastErrorMsg()));
}

void add_points(OGRSimpleCurve& curve, const std::vector<Point3>& points, bool flat, bool close) {
    for (const Point3& p : points) flat ? curve.addPoint(p.x, p.y) : curve.addPoint(p.x, p.y, p.z);
    if (close) curve.closeRings();
}

std::unique_ptr<OGRGeometry> geometry_of(const MapFeature& feature, bool flat) {
    if (feature.kind == MapFeature::Kind::Point) {
        const Point3& p = feature.parts.at(0).at(0);
        return flat ? std::make_unique<OGRPoint>(p.x, p.y) : std::make_unique<OGRPoint>(p.x, p.y, p.z);
    }
    if (feature.kind == MapFeature::Kind::Line) {
        auto line = std::make_unique<OGRLineString>();
        add_points(*line, feature.parts.at(0), flat, false);
        return line;
    }
    auto polygon = std::make_unique<OGRPolygon>();
    for (const auto& part : feature.parts) {
        OGRLinearRing ring;
        add_points(ring, part, flat, true);
        polygon->addRing(&ring);
    }
    return polygon;
}

OGRwkbGeometryType type_of(const std::vector<MapFeature>& features, bool flat) {
    const auto type_of_kind = [](MapFeature::Kind kind) {
        return kind == MapFeature::Kind::Point  ? wkbPoint
               : kind == MapFeature::Kind::Line ? wkbLineString
                                                : wkbPolygon;
    };
    OGRwkbGeometryType type = features.empty() ? wkbUnknown : type_of_kind(features[0].kind);
    for (const MapFeature& feature : features)
        if (type_of_kind(feature.kind) != type) return wkbUnknown;
    return flat || type == wkbUnknown ? type : OGR_GT_SetZ(type);
}

void create_fields(OGRLayer& layer, const std::vector<MapFeature>& features,
                   const std::filesystem::path& file) {
    const auto create = [&](const char* name, OGRFieldType type) {
        OGRFieldDefn field(name, type);
        if (layer.CreateField(&field) != OGRERR_NONE) fail(file);
    };
    create("layer", OFTString);
    create("color", OFTString);
    if (features.empty()) return;
    for (const auto& [name, value] : features.front().attributes)
        create(name.c_str(), std::holds_alternative<double>(value) ? OFTReal : OFTString);
}

void fill(OGRFeature& out, const MapFeature& feature, bool is_dxf) {
    if (is_dxf) {
        out.SetField("Layer", feature.layer.c_str());
        std::string style = fmt::format("PEN(c:{})", feature.color);
        if (feature.kind == MapFeature::Kind::Polygon) style += fmt::format(";BRUSH(fc:{})", feature.color);
        out.SetStyleString(style.c_str());
        return;
    }
    out.SetField("layer", feature.layer.c_str());
    out.SetField("color", feature.color.c_str());
    for (const auto& [name, value] : feature.attributes) {
        if (const auto* number = std::get_if<double>(&value))
            out.SetField(name.c_str(), *number);
        else
            out.SetField(name.c_str(), std::get<std::string>(value).c_str());
    }
}

//! A GeoPackage without a reference system is taken for degrees.
std::shared_ptr<OGRSpatialReference> plane_reference() {
    auto result = std::make_shared<OGRSpatialReference>();
    result->SetLocalCS("Undefined Cartesian SRS");
    return result;
}

void write_dataset(const std::filesystem::path& file, const std::vector<MapFeature>& features,
                   const FeatureFileOptions& options, const char* driver_name) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
    if (driver == nullptr)
        throw IoError(fmt::format("{}: this GDAL has no driver {}", file.string(), driver_name));
    auto crs = map_reference(options.crs);
    if (!crs && std::string_view(driver_name) == "GPKG") crs = plane_reference();
    Dataset dataset(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr), &GDALClose);
    if (!dataset) fail(file);
    const bool is_dxf = std::string_view(driver_name) == "DXF";
    OGRLayer* layer = dataset->CreateLayer(is_dxf ? "entities" : options.table.c_str(), crs.get(),
                                           type_of(features, options.flat), nullptr);
    if (layer == nullptr) fail(file);
    if (!is_dxf) create_fields(*layer, features, file);
    if (!is_dxf && layer->StartTransaction() != OGRERR_NONE) fail(file);
    for (const MapFeature& feature : features) {
        OGRFeature out(layer->GetLayerDefn());
        fill(out, feature, is_dxf);
        out.SetGeometryDirectly(geometry_of(feature, options.flat).release());
        if (layer->CreateFeature(&out) != OGRERR_NONE) fail(file);
    }
    if (!is_dxf && layer->CommitTransaction() != OGRERR_NONE) fail(file);
    dataset->FlushCache();
}

}  // namespace

bool is_feature_file(const std::filesystem::path& file) {
    return driver_of(file) != nullptr;
}

void write_features(const std::filesystem::path& file, const std::vector<MapFeature>& features,
                    const FeatureFileOptions& options) {
    const char* driver = driver_of(file);
    if (driver == nullptr) throw IoError(file.string() + ": features are written as .gpkg, .dxf or .geojson");
    GDALAllRegister();
    const QuietErrors quiet;
    replace_aside(file, [&](const std::filesystem::path& temporary) {
        write_dataset(temporary, features, options, driver);
    });
}

}  // namespace stratareeb
