// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "boreholes/rule_columns.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! Horizons under layer rules. The lines in which a younger unit cuts an older one off are level sets of the uncut surfaces,
//! which are linear over the plan's triangles: they become edges of the plan mesh. A vertex close to such a line, if
//! nothing else stands on it, is moved there; other edges are cut. Beyond its line a layer has thickness 0 to the last bit.
//! `columns` are the uncut columns at the plan's vertices, model.columns what the holes have.
//! \pre plan, regions (of uncut layers), units and columns of the model are set.
//! \throw GeometryError where a layer that a hole has can't be kept there.
void cut_layers(LayerModel& model, const std::vector<LayerSequence>& sequences, const LayerRules& rules,
                std::vector<UncutColumn> columns, double thinnest, double opening);

}  // namespace stratareeb
