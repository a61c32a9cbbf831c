// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A grid of heights, the first band of a raster. Values belong to cell centres.
struct Raster {
    int columns = 0, rows = 0;
    std::array<double, 6> to_map{0, 1, 0,
                                 0, 0, 1};  // map x = g0 + column·g1 + row·g2, y = g3 + column·g4 + row·g5;
                                            // columns and rows count from the outer corner of the first cell
    std::vector<double> heights;            // row by row; NaN = no data
    std::string crs;                        // as WKT; may be empty

    //! Bilinear between cell centres, constant over the outermost half cell; nullopt outside and where a cell
    //! with a share in the value has no data.
    std::optional<double> sample(double x, double y) const;

    //! The corners of the box around all cells.
    Point2 low() const;
    Point2 high() const;
};

//! Read the first band of any raster that GDAL opens (GeoTIFF, ESRI ASCII grid, …), with its scale and offset
//! applied.
//! \throw IoError if it can't be opened or read, InvalidInput if it has no cells, no place on the
//! map or over 10⁹ cells.
Raster read_raster(const std::string& path);

}  // namespace stratareeb
