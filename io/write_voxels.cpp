// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_voxels.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <numeric>

#include "boreholes/errors.h"
#include "io/map_reference.h"
#include "io/quiet_gdal.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& file) {
    throw IoError(fmt::format("{}: can't be written: {}", file.string(), CPLGetLastErrorMsg()));
}

GDALDriver& driver(const Path& file, const char* name) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
    if (driver == nullptr) throw IoError(fmt::format("{}: this GDAL has no driver {}", file.string(), name));
    return *driver;
}

//! Numbers up to 255 in one byte.
GDALDataType stored_type(const std::vector<Unit>& units) {
    return units.size() < 256 ? GDT_Byte : GDT_UInt16;
}

void write_geotiff(const Path& file, const VoxelBlock& block, const std::vector<Unit>& units,
                   OGRSpatialReference* crs) {
    const char* options[] = {"COMPRESS=DEFLATE", "TILED=YES", "BIGTIFF=IF_SAFER", "INTERLEAVE=BAND", nullptr};
    const auto columns = static_cast<int>(block.plan.columns), rows = static_cast<int>(block.plan.rows);
    constexpr std::size_t kMostBands = 65535;
    if (block.levels > kMostBands)
        throw InvalidInput(fmt::format("{} levels, more than {} bands: give higher cells, or write .nc",
                                       block.levels, kMostBands));
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> dataset(
        driver(file, "GTiff")
            .Create(file.c_str(), columns, rows, static_cast<int>(block.levels), stored_type(units),
                    const_cast<char**>(options)),
        &GDALClose);
    if (!dataset) fail(file);
    double transform[] = {block.plan.north_west.x, block.plan.cell, 0, block.plan.north_west.y, 0,
                          -block.plan.cell};
    if (dataset->SetGeoTransform(transform) != CE_None) fail(file);
    if (crs != nullptr && dataset->SetSpatialRef(crs) != CE_None) fail(file);
    dataset->SetMetadataItem("LEVEL_HEIGHT", fmt::format("{}", block.height).c_str());
    for (std::size_t i = 0; i < units.size(); ++i)
        dataset->SetMetadataItem(fmt::format("UNIT_{}", i + 1).c_str(), units[i].code.c_str());
    for (std::size_t b = 0; b < block.levels; ++b) {
        const std::size_t level = block.levels - 1 - b;
        GDALRasterBand* band = dataset->GetRasterBand(static_cast<int>(b) + 1);
        band->SetDescription(fmt::format("z {:.12g}", block.middle(level)).c_str());
        auto* values = const_cast<std::uint16_t*>(block.units.data() + level * block.cells_per_level());
        if (band->SetNoDataValue(0) != CE_None ||
            band->RasterIO(GF_Write, 0, 0, columns, rows, values, columns, rows, GDT_UInt16, 0, 0, nullptr) !=
                CE_None)
            fail(file);
    }
    dataset->FlushCache();
    if (CPLGetLastErrorType() == CE_Failure) fail(file);  // FlushCache returns nothing before GDAL 3.7
}

//! A word of letters, digits and underscores, as flag_meanings needs.
std::string flag_word(const std::string& code) {
    std::string word;
    for (const char c : code) word += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return word.empty() ? "_" : word;
}

class NetCdf {
 public:
    NetCdf(const Path& file, const VoxelBlock& block) : file_(file), block_(block) {
        dataset_.reset(driver(file, "netCDF").CreateMultiDimensional(file.c_str(), nullptr, nullptr));
        if (!dataset_) fail(file_);
        root_ = dataset_->GetRootGroup();
        text(*root_, "Conventions", "CF-1.8");
        text(*root_, "title", "Block of geological units");
    }

    void write(const std::vector<Unit>& units, const std::string& length_unit, OGRSpatialReference* crs) {
        const PlanGrid& plan = block_.plan;
        const double south = plan.north_west.y - plan.cell * static_cast<double>(plan.rows);
        const auto z = axis("z", "Z", "altitude", block_.levels, block_.bottom, block_.height, length_unit);
        const auto y = axis("y", "Y", "projection_y_coordinate", plan.rows, south, plan.cell, length_unit);
        const auto x = axis("x", "X", "projection_x_coordinate", plan.columns, plan.north_west.x, plan.cell,
                            length_unit);
        const char* options[] = {"COMPRESS=DEFLATE", nullptr};
        const auto unit = root_->CreateMDArray(
            "unit", {z, y, x}, GDALExtendedDataType::Create(stored_type(units)), const_cast<char**>(options));
        if (!unit) fail(file_);
        text(*unit, "long_name", "number of the layer, 1 = top");
        flags(*unit, units);
        if (crs != nullptr && !unit->SetSpatialRef(crs)) fail(file_);
        stored_type(units) == GDT_Byte ? write_units<std::uint8_t>(*unit, GDT_Byte)
                                       : write_units<std::uint16_t>(*unit, GDT_UInt16);
    }

 private:
    template <class Holder>
    void text(Holder& holder, const char* name, const std::string& value) {
        const auto attribute = holder.CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
        if (!attribute || !attribute->Write(value.c_str())) fail(file_);
    }

    std::shared_ptr<GDALDimension> axis(const char* name, const char* letter, const char* standard_name,
                                        std::size_t count, double first, double step,
                                        const std::string& length_unit) {
        auto dimension = root_->CreateDimension(name, "", "", count);
        if (!dimension) fail(file_);
        const auto array = root_->CreateMDArray(name, {dimension}, GDALExtendedDataType::Create(GDT_Float64));
        if (!array) fail(file_);
        text(*array, "standard_name", standard_name);
        text(*array, "axis", letter);
        text(*array, "units", length_unit == "us-ft" ? "US_survey_foot" : length_unit);
        if (*letter == 'Z') text(*array, "positive", "up");
        std::vector<double> middles(count);
        for (std::size_t i = 0; i < count; ++i) middles[i] = first + (static_cast<double>(i) + 0.5) * step;
        const GUInt64 start = 0;
        if (!array->Write(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64),
                          middles.data()))
            fail(file_);
        return dimension;
    }

    template <class Number>
    void flag_values(GDALMDArray& unit, std::size_t last) {
        std::vector<Number> values(last + 1);
        std::iota(values.begin(), values.end(), Number{0});
        const auto type = GDALExtendedDataType::Create(sizeof(Number) == 1 ? GDT_Byte : GDT_UInt16);
        const auto attribute = unit.CreateAttribute("flag_values", {values.size()}, type);
        if (!attribute || !attribute->Write(values.data(), values.size() * sizeof(Number))) fail(file_);
    }

    void flags(GDALMDArray& unit, const std::vector<Unit>& units) {
        std::string meanings = "none";
        for (const Unit& u : units) meanings += " " + flag_word(u.code);
        // The driver takes values as they are stored (those of Write(int…) it mistakes for bytes).
        stored_type(units) == GDT_Byte ? flag_values<std::uint8_t>(unit, units.size())
                                       : flag_values<std::uint16_t>(unit, units.size());
        text(unit, "flag_meanings", meanings);
    }

    //! y ascends in the file, rows descend in the block. In the type that is stored: any other is written value by value.
    template <class Number>
    void write_units(GDALMDArray& unit, GDALDataType type) {
        const PlanGrid& plan = block_.plan;
        std::vector<Number> level(block_.cells_per_level());
        for (std::size_t k = 0; k < block_.levels; ++k) {
            for (std::size_t row = 0; row < plan.rows; ++row) {
                const auto* from = block_.units.data() + (k * plan.rows + row) * plan.columns;
                std::transform(
                    from, from + plan.columns,
                    level.begin() + static_cast<std::ptrdiff_t>((plan.rows - 1 - row) * plan.columns),
                    [](auto number) { return static_cast<Number>(number); });
            }
            const GUInt64 start[] = {k, 0, 0};
            const std::size_t count[] = {1, plan.rows, plan.columns};
            if (!unit.Write(start, count, nullptr, nullptr, GDALExtendedDataType::Create(type), level.data()))
                fail(file_);
        }
    }

    Path file_;
    const VoxelBlock& block_;
    std::unique_ptr<GDALDataset> dataset_;
    std::shared_ptr<GDALGroup> root_;
};

}  // namespace

bool is_voxel_file(const Path& file) {
    return file.extension() == ".nc" || file.extension() == ".tif" || file.extension() == ".tiff";
}

void write_voxels(const Path& file, const VoxelBlock& block, const std::vector<Unit>& units,
                  const std::string& length_unit, const std::string& crs) {
    if (!is_voxel_file(file)) throw IoError(file.string() + ": blocks are written as .nc or .tif");
    const auto reference = map_reference(crs);
    GDALAllRegister();
    const QuietErrors quiet;
    replace_aside(file, [&](const Path& temporary) {
        CPLErrorReset();
        if (file.extension() == ".nc")
            NetCdf(temporary, block).write(units, length_unit, reference.get());
        else
            write_geotiff(temporary, block, units, reference.get());
    });
}

}  // namespace stratareeb
