// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! Elevations of one block at a place, top down, to be changed in place.
using LevelColumn = std::vector<double*>;

//! Elevations of several blocks at one place that differ by no more than a tolerance, by rounding, become the same number;
//! horizons of one block that are apart stay apart.
void equal_levels(const std::vector<LevelColumn>& columns, double tolerance);

//! The seams of a faulted model whose plan was cut finer, old vertices keeping their numbers: where one side of a fault has a new
//! vertex the other gets one, and `model.seams` are found anew.
//! \pre model.seams are those before; model.regions are those of the finer plan
void match_seams(LayerModel& model);

}  // namespace stratareeb
