// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_raster.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"
#include "io/quiet_gdal.h"

namespace stratareeb {
namespace {

constexpr double kMostCells = 1e9;

std::array<Point2, 4> corners(const Raster& raster) {
    const auto& g = raster.to_map;
    std::array<Point2, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
        const double column = i % 2 == 0 ? 0 : raster.columns, row = i < 2 ? 0 : raster.rows;
        points[i] = {g[0] + column * g[1] + row * g[2], g[3] + column * g[4] + row * g[5]};
    }
    return points;
}

void read_heights(GDALRasterBand& band, const std::string& path, Raster& raster) {
    raster.heights.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
    if (band.RasterIO(GF_Read, 0, 0, raster.columns, raster.rows, raster.heights.data(), raster.columns,
                      raster.rows, GDT_Float64, 0, 0, nullptr) != CE_None)
        throw IoError(fmt::format("{}: can't be read ({})", path, CPLGetLastErrorMsg()));
    int has_nodata = 0, has_scale = 0, has_offset = 0;
    const double nodata = band.GetNoDataValue(&has_nodata);
    double scale = band.GetScale(&has_scale), offset = band.GetOffset(&has_offset);
    if (!has_scale) scale = 1;
    if (!has_offset) offset = 0;
    const bool is_float = band.GetRasterDataType() == GDT_Float32;
    for (double& height : raster.heights) {
        const bool missing =
            has_nodata &&
            (height == nodata || (is_float && static_cast<float>(height) == static_cast<float>(nodata)));
        height = missing || !std::isfinite(height) ? std::numeric_limits<double>::quiet_NaN()
                                                   : height * scale + offset;
    }
}

}  // namespace

std::optional<double> Raster::sample(double x, double y) const {
    const auto& g = to_map;
    const double determinant = g[1] * g[5] - g[2] * g[4], dx = x - g[0], dy = y - g[3];
    const double column = (g[5] * dx - g[2] * dy) / determinant, row = (g[1] * dy - g[4] * dx) / determinant;
    if (!(column >= 0 && row >= 0 && column <= columns && row <= rows)) return std::nullopt;
    const double u = std::clamp(column - 0.5, 0.0, columns - 1.0), v = std::clamp(row - 0.5, 0.0, rows - 1.0);
    const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
    const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
    double sum = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::size_t a = corner % 2, b = corner / 2;
        const double weight = (a ? s : 1 - s) * (b ? t : 1 - t);
        if (weight == 0) continue;
        sum += weight * heights[(j + b) * static_cast<std::size_t>(columns) + i + a];
    }
    if (std::isnan(sum)) return std::nullopt;
    return sum;
}

Point2 Raster::low() const {
    const auto points = corners(*this);
    Point2 low = points[0];
    for (const Point2& p : points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    return low;
}

Point2 Raster::high() const {
    const auto points = corners(*this);
    Point2 high = points[0];
    for (const Point2& p : points) high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    return high;
}

Raster read_raster(const std::string& path) {
    GDALAllRegister();
    const QuietErrors quiet;
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset || dataset->GetRasterCount() == 0)
        throw IoError(fmt::format("{}: not a raster that can be opened{}", path,
                                  *CPLGetLastErrorMsg() ? fmt::format(" ({})", CPLGetLastErrorMsg()) : ""));
    Raster raster;
    raster.columns = dataset->GetRasterXSize();
    raster.rows = dataset->GetRasterYSize();
    if (raster.columns < 1 || raster.rows < 1) throw InvalidInput(path + ": the raster has no cells");
    if (double(raster.columns) * raster.rows > kMostCells)
        throw InvalidInput(fmt::format("{}: {} × {} cells are too many; cut out the site", path,
                                       raster.columns, raster.rows));
    if (dataset->GetGeoTransform(raster.to_map.data()) != CE_None ||
        raster.to_map[1] * raster.to_map[5] == raster.to_map[2] * raster.to_map[4])
        throw InvalidInput(path + ": the raster has no place on the map (no geotransform)");
    raster.crs = dataset->GetProjectionRef() ? dataset->GetProjectionRef() : "";
    read_heights(*dataset->GetRasterBand(1), path, raster);
    return raster;
}

}  // namespace stratareeb
