// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/staged_folder.h"
#include "mesh/layer_model.h"
#include "mesh/model_grid.h"

namespace stratareeb {

//! A layer model on a grid of square cells, as groundwater models take it: one model layer a unit.
struct FlowGrid {
    PlanGrid plan;
    std::vector<double> top;                  // [cell] elevation of the ground; 0 outside
    std::vector<std::vector<double>> bottom;  // [layer][cell], never above what lies over it; 0 outside
    //! [layer][cell]: 1 active, -1 passed through (the unit is absent, or thinner than asked for), 0 outside.
    std::vector<std::vector<int>> idomain;

    std::size_t cells() const { return plan.columns * plan.rows; }
    double thickness(std::size_t layer, std::size_t cell) const {
        return (layer == 0 ? top[cell] : bottom[layer - 1][cell]) - bottom[layer][cell];
    }
};

//! Elevations at the middles of cells. Units thinner than `thinnest` in a cell (and absent ones) are passed through.
FlowGrid flow_grid(const LayerModel& model, const PlanGrid& plan, double thinnest = 0);

//! Write the discretisation of MODFLOW 6 (DIS package) into a folder: model.dis and its arrays top.txt, botm_01.txt, …,
//! idomain_01.txt, … (free format, a row a line, from the north-west), and layers.csv, which names the unit of each layer.
void write_modflow(StagedFolder& folder, const FlowGrid& grid, const LayerModel& model);

}  // namespace stratareeb
