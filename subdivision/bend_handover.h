// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/layer_creases.h"
#include "subdivision/loop_topology.h"

namespace stratareeb {

//! What each layer below takes over from an ending one: thickness at the finest level, 0 but around the pinch-out line,
//! that makes up for the bend there, so that the sum of both layers is smooth. It is the difference between the ending
//! layer's thickness without the crease and with it, and not negative but for rounding where creases end.
//! \param thickness the ending layer's, at the finest level
std::map<std::size_t, std::vector<double>> bends_handed_over(const LayerModel& control,
                                                             const LayerCreases& creases,
                                                             const LoopTopology& topology, std::size_t layer,
                                                             const std::vector<double>& control_thickness,
                                                             const std::vector<double>& thickness);

}  // namespace stratareeb
