// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_table.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/csv_table.h"
#include "io/quiet_gdal.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostColumns = 10000;

std::string lower_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

bool is_text_file(const std::string& path) {
    constexpr std::array<std::string_view, 5> kText{".csv", ".tsv", ".txt", ".dat", ".xyz"};
    const std::string extension = lower_extension(path);
    return std::find(kText.begin(), kText.end(), extension) != kText.end();
}

//! OGR settings for this thread, put back at the end: spreadsheet cells as text, no row taken as header.
class PlainSpreadsheets {
 public:
    PlainSpreadsheets() {
        for (std::size_t i = 0; i < kKeys.size(); ++i) {
            if (const char* value = CPLGetThreadLocalConfigOption(kKeys[i], nullptr)) before_[i] = value;
            CPLSetThreadLocalConfigOption(kKeys[i], i % 2 == 0 ? "DISABLE" : "STRING");
        }
    }
    ~PlainSpreadsheets() {
        for (std::size_t i = 0; i < kKeys.size(); ++i)
            CPLSetThreadLocalConfigOption(kKeys[i], before_[i] ? before_[i]->c_str() : nullptr);
    }
    PlainSpreadsheets(const PlainSpreadsheets&) = delete;
    PlainSpreadsheets& operator=(const PlainSpreadsheets&) = delete;

 private:
    static constexpr std::array<const char*, 6> kKeys{"OGR_XLSX_HEADERS", "OGR_XLSX_FIELD_TYPES",
                                                      "OGR_XLS_HEADERS",  "OGR_XLS_FIELD_TYPES",
                                                      "OGR_ODS_HEADERS",  "OGR_ODS_FIELD_TYPES"};
    std::array<std::optional<std::string>, 6> before_;
};

struct Source {
    std::string path, sheet;
};

//! Split "book.xlsx:Sheet", unless the whole is a file.
Source split_source(const std::string& source) {
    std::error_code none;
    if (std::filesystem::exists(source, none)) return {source, ""};
    const auto colon = source.rfind(':');
    if (colon != source.npos && std::filesystem::is_regular_file(source.substr(0, colon), none))
        return {source.substr(0, colon), source.substr(colon + 1)};
    return {source, ""};
}

bool is_spreadsheet(GDALDataset& dataset) {
    const std::string driver = dataset.GetDriver() ? dataset.GetDriver()->GetDescription() : "";
    return driver == "XLSX" || driver == "XLS" || driver == "ODS";
}

std::string field_text(const OGRFeature& feature, int field) {
    if (!feature.IsFieldSetAndNotNull(field)) return "";
    if (feature.GetFieldDefnRef(field)->GetType() == OFTReal)
        return fmt::format("{}", feature.GetFieldAsDouble(field));  // shortest text that reads back exactly
    return feature.GetFieldAsString(field);
}

void add_feature(TextTable& table, OGRFeature& feature, std::size_t line) {
    if (table.has_geometry) {
        const OGRGeometry* geometry = feature.GetGeometryRef();
        const bool point =
            geometry && !geometry->IsEmpty() && wkbFlatten(geometry->getGeometryType()) == wkbPoint;
        table.add_cell(point ? fmt::format("{}", geometry->toPoint()->getX()) : "");
        table.add_cell(point ? fmt::format("{}", geometry->toPoint()->getY()) : "");
    }
    for (int i = 0; i < feature.GetFieldCount(); ++i) table.add_cell(trimmed(field_text(feature, i)));
    table.end_row(line);
}

std::vector<std::string> layer_columns(OGRLayer& layer, bool has_geometry) {
    std::vector<std::string> names;
    if (has_geometry) names = {"geometry_x", "geometry_y"};
    for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
        names.emplace_back(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
    return names;
}

std::string reference_text(OGRLayer& layer) {
    const OGRSpatialReference* reference = layer.GetSpatialRef();
    // A GeoPackage's way to say that nothing is known: "Undefined Cartesian SRS", "Undefined geographic SRS".
    if (reference != nullptr && reference->GetName() != nullptr &&
        std::string_view(reference->GetName()).starts_with("Undefined "))
        return {};
    char* text = nullptr;
    std::string wkt;
    if (reference != nullptr && reference->exportToWkt(&text) == OGRERR_NONE && text != nullptr) wkt = text;
    CPLFree(text);
    return wkt;
}

bool has_text(const OGRFeature& feature) {
    for (int i = 0; i < feature.GetFieldCount(); ++i)
        if (feature.IsFieldSetAndNotNull(i)) return true;
    return feature.GetGeometryRef() != nullptr;
}

TextTable layer_table(const std::string& source, OGRLayer& layer, bool spreadsheet) {
    TextTable table;
    table.source = source;
    table.sheet = layer.GetName();
    table.has_geometry = !spreadsheet && layer.GetGeomType() != wkbNone;
    if (table.has_geometry) table.crs = reference_text(layer);
    const auto names = layer_columns(layer, table.has_geometry);
    if (names.size() > kMostColumns)
        throw InvalidInput(
            fmt::format("{}: {} has {} columns: not a borehole table", source, table.sheet, names.size()));
    if (!spreadsheet) table.field_names = names;
    layer.ResetReading();
    std::size_t count = 0;
    while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
        ++count;
        if (has_text(*feature)) add_feature(table, *feature, count);
    }
    return table;
}

//! A formatted but blank cell in the last possible row of a sheet; all data before it is read.
bool is_trailing_blank_error() {
    return std::string_view(CPLGetLastErrorMsg()).find("Too big gap") != std::string_view::npos;
}

std::vector<TextTable> ogr_tables(const std::string& name, const Source& source) {
    static std::once_flag registered;
    std::call_once(registered, [] { GDALAllRegister(); });
    const PlainSpreadsheets plain;
    const QuietErrors quiet;
    const std::unique_ptr<GDALDataset> dataset(
        GDALDataset::Open(source.path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset) {
        const std::string why = CPLGetLastErrorMsg();
        throw IoError(
            fmt::format("{}: not a table that can be opened{}", name, why.empty() ? "" : " (" + why + ")"));
    }
    std::vector<TextTable> tables;
    std::string sheets;
    for (int i = 0; i < dataset->GetLayerCount(); ++i) {
        OGRLayer& layer = *dataset->GetLayer(i);
        sheets += (sheets.empty() ? "" : ", ") + std::string(layer.GetName());
        if (source.sheet.empty() || source.sheet == layer.GetName())
            tables.push_back(layer_table(name, layer, is_spreadsheet(*dataset)));
    }
    if (tables.empty())
        throw IoError(sheets.empty()
                          ? name + ": holds no table"
                          : fmt::format("{}: no sheet or layer {}; it has {}", name, source.sheet, sheets));
    if (CPLGetLastErrorType() >= CE_Failure && !is_trailing_blank_error())
        throw IoError(fmt::format("{}: {}", name, CPLGetLastErrorMsg()));
    return tables;
}

void check_file(const std::string& name, const std::string& path) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none) && lower_extension(path) != ".gdb")
        throw IoError(name + ": is a directory; name a file in it");
    if (is_text_file(path) && !std::filesystem::exists(path, none)) throw IoError(name + ": no such file");
    if (std::filesystem::is_regular_file(path, none) && std::filesystem::file_size(path, none) == 0)
        throw InvalidInput(name + ": the file is empty");
}

}  // namespace

std::vector<TextTable> read_tables(const std::string& name) {
    const Source source = split_source(name);
    check_file(name, source.path);
    if (!is_text_file(source.path)) return ogr_tables(name, source);
    std::vector<TextTable> tables;
    tables.push_back(read_csv_table(source.path));
    return tables;
}

}  // namespace stratareeb
