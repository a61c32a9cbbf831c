// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Values at the middles of square cells, row after row from the north-west; NaN where there is none.
struct Grid {
    Point2 north_west;  // corner of the first cell, map coordinates
    double cell = 1;    // side
    std::size_t columns = 0, rows = 0;
    struct Band {
        std::string name;
        std::vector<double> values;
    };
    std::vector<Band> bands;

    Point2 middle(std::size_t column, std::size_t row) const {
        return {north_west.x + (static_cast<double>(column) + 0.5) * cell,
                north_west.y - (static_cast<double>(row) + 0.5) * cell};
    }
};

//! Write a grid as .tif (GeoTIFF, double, compressed, all bands) or .asc (ESRI ASCII grid, one band). Cells without a value hold
//! -9999, which the file names as its no-data value.
//! \throw IoError for another extension, several bands in .asc, or if the file can't be written; InvalidInput for an unknown CRS
void write_grid(const std::filesystem::path& file, const Grid& grid, const std::string& crs = {});

bool is_grid_file(const std::filesystem::path& file);

}  // namespace stratareeb
