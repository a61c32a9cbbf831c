// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/layer_model.h"
#include "mesh/model_grid.h"

namespace stratareeb {

//! Cells of equal size over a model's plan and height; which layer is at the middle of each.
struct VoxelBlock {
    PlanGrid plan;
    double bottom = 0;       // elevation of the lowest level's floor, map coordinates
    double height = 1;       // of a level
    std::size_t levels = 0;  // from below
    //! 0: no layer (above the ground, below the model, outside the footprint); else 1 = top layer. Level by level from below,
    //! each row by row from the north-west.
    std::vector<std::uint16_t> units;

    std::size_t cells_per_level() const { return plan.columns * plan.rows; }
    double middle(std::size_t level) const { return bottom + (static_cast<double>(level) + 0.5) * height; }
    std::uint16_t unit(std::size_t level, std::size_t row, std::size_t column) const {
        return units[level * cells_per_level() + row * plan.columns + column];
    }
};

//! Which layer is at the middle of each cell; the upper one where two meet. Cells' sides lie at multiples of their size.
//! Volumes counted in cells are off by no more than the cells that a layer's surface meets, mostly far less.
//! \throw InvalidInput if a size is not above 0, or there would be more than 2·10^9 cells
VoxelBlock voxel_block(const LayerModel& model, double cell, double height);

//! Volume of each layer as its number of cells gives it.
std::vector<double> voxel_volumes(const VoxelBlock& block, std::size_t layers);

}  // namespace stratareeb
