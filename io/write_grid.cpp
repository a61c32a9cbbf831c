// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_grid.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>

#include "boreholes/errors.h"
#include "io/map_reference.h"
#include "io/quiet_gdal.h"
#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

constexpr double kNoData = -9999;

double stored(double value) {
    return std::isfinite(value) ? value : kNoData;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw IoError(fmt::format("{}: can't be written: {}", file.string(), CPLGetLastErrorMsg()));
}

void write_geotiff(const std::filesystem::path& file, const Grid& grid, OGRSpatialReference* crs) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) throw IoError(file.string() + ": this GDAL has no driver GTiff");
    const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "BIGTIFF=IF_SAFER", nullptr};
    const auto columns = static_cast<int>(grid.columns), rows = static_cast<int>(grid.rows);
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> dataset(
        driver->Create(file.c_str(), columns, rows, static_cast<int>(grid.bands.size()), GDT_Float64,
                       const_cast<char**>(options)),
        &GDALClose);
    if (!dataset) fail(file);
    double transform[] = {grid.north_west.x, grid.cell, 0, grid.north_west.y, 0, -grid.cell};
    if (dataset->SetGeoTransform(transform) != CE_None) fail(file);
    if (crs != nullptr && dataset->SetSpatialRef(crs) != CE_None) fail(file);
    std::vector<double> values;
    for (std::size_t b = 0; b < grid.bands.size(); ++b) {
        GDALRasterBand* band = dataset->GetRasterBand(static_cast<int>(b) + 1);
        band->SetDescription(grid.bands[b].name.c_str());
        if (band->SetNoDataValue(kNoData) != CE_None) fail(file);
        values = grid.bands[b].values;
        for (double& value : values) value = stored(value);
        if (band->RasterIO(GF_Write, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0,
                           nullptr) != CE_None)
            fail(file);
    }
}

//! GDAL's own AAIGrid writer rounds to a number of digits of its choice.
void write_ascii_grid(std::ostream& stream, const Grid& grid) {
    TextOutput out(stream);
    out.print("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value {}\n", grid.columns,
              grid.rows, grid.north_west.x, grid.north_west.y - grid.cell * static_cast<double>(grid.rows),
              grid.cell, kNoData);
    const auto& values = grid.bands[0].values;
    for (std::size_t i = 0; i < values.size(); ++i)
        out.print("{}{}", stored(values[i]), (i + 1) % grid.columns == 0 ? "\n" : " ");
}

}  // namespace

bool is_grid_file(const std::filesystem::path& file) {
    return file.extension() == ".tif" || file.extension() == ".tiff" || file.extension() == ".asc";
}

void write_grid(const std::filesystem::path& file, const Grid& grid, const std::string& crs) {
    const auto reference = map_reference(crs);
    if (file.extension() == ".asc") {
        if (grid.bands.size() != 1)
            throw IoError(file.string() + ": an ESRI ASCII grid holds one band; write .tif for several");
        return write_aside(file, [&](std::ostream& out) { write_ascii_grid(out, grid); });
    }
    if (!is_grid_file(file)) throw IoError(file.string() + ": grids are written as .tif or .asc");
    GDALAllRegister();
    const QuietErrors quiet;
    replace_aside(file, [&](const std::filesystem::path& temporary) {
        write_geotiff(temporary, grid, reference.get());
    });
}

}  // namespace stratareeb
