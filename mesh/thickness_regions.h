// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/layer_regions.h"

namespace stratareeb {

//! Regions of a plan mesh whose edges hold all lines of no thickness: a triangle has a layer where one of its corners has
//! thickness, see LayerRegions.
//! \param horizons [k][vertex], in order
LayerRegions regions_of_thickness(const TriMesh& plan, const std::vector<std::vector<double>>& horizons);

}  // namespace stratareeb
