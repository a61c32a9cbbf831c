// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/point.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! How far the middles of about a thousand equal parts of a model's plan, or of a window in it, are from the nearest of some sites (map
//! coordinates).
//! \param areas of the window in each plan triangle
//! \return empty where the window has no area
std::vector<double> plan_gaps(const LayerModel& model, std::span<const Point2> sites,
                              std::span<const double> areas);

}  // namespace stratareeb
