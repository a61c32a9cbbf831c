// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! Square cells over a model's plan, row after row from the north-west.
struct PlanGrid {
    Point2 north_west;  // map coordinates
    double cell = 1;
    std::size_t columns = 0, rows = 0;
};

//! Cells of a size that cover the footprint, their corners at multiples of the size.
//! \throw InvalidInput if the size is not above 0 or there would be more than 10^9 cells
PlanGrid grid_over(const LayerModel& model, double cell);

//! Fields that are linear over each plan triangle, at the middles of all cells; NaN outside the footprint. Triangle by triangle: time
//! in proportion to triangles and cells. result[field][cell]
std::vector<std::vector<double>> rasterized(const LayerModel& model, const PlanGrid& grid,
                                            const std::vector<const std::vector<double>*>& fields);

}  // namespace stratareeb
