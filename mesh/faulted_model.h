// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/fault_blocks.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! A layer model cut along vertical faults: the traces part the footprint into blocks (fault_blocks), each block is predicted
//! from its own holes alone, and the blocks' horizons may be at any height beside each other. All solids are closed, and two that
//! touch along a fault have the same triangles there (join_blocks).
//! \param traces in map coordinates
//! \param finish done to each block's model before they are joined, as refine_layers
//! \return without any trace inside the footprint, the model without faults
//! \throw as build_layer_model and fault_blocks do
LayerModel build_faulted_model(const Survey& survey, const FaultTraces& traces,
                               LayerModelOptions options = {},
                               const std::function<LayerModel(LayerModel)>& finish = {});

}  // namespace stratareeb
