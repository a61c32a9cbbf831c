// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! The nearest elevation to `level` from which every value keeps a distance of `clearance`: a level through no vertex.
//! \param values ascending
double clear_level(const std::vector<double>& values, double level, double clearance);

//! The same model over a finer plan mesh, in which the line where a horizon is at a level consists of edges, for every horizon
//! and level. At a vertex of such a line the horizon has the level's value to the last bit. Old vertices keep their
//! numbers; absent layers stay absent. Levels (in the model's frame) may pass through no vertex: see clear_level.
//! \throw InvalidInput if one does
LayerModel cut_at_levels(const LayerModel& model, const std::vector<double>& levels);

}  // namespace stratareeb
