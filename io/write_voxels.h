// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/voxel_block.h"

namespace stratareeb {

bool is_voxel_file(const std::filesystem::path& file);

//! Write a block of units:
//!  - .nc, NetCDF after the CF conventions 1.8: variable unit(z, y, x), all three ascending, with coordinates of cells' middles,
//!    flag_values and flag_meanings;
//!  - .tif, GeoTIFF: one band a level, the highest first, named by the elevation of its middle; codes as metadata UNIT_1, …
//! 0 is no layer, 1 the top layer.
//! \throw IoError for another extension, without GDAL's driver, or if the file can't be written; InvalidInput for an unknown CRS
void write_voxels(const std::filesystem::path& file, const VoxelBlock& block, const std::vector<Unit>& units,
                  const std::string& length_unit, const std::string& crs = {});

}  // namespace stratareeb
