// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! A connected part of the plan: an outer ring, counter-clockwise, then holes, clockwise; map coordinates, without a
//! repeated last point.
struct PlanArea {
    std::size_t label = 0;
    std::vector<std::vector<Point2>> rings;
};

constexpr std::size_t kNoLabel = std::numeric_limits<std::size_t>::max();

//! Triangles of the plan with the same label, as areas that share the plan's own edges, label by label. kNoLabel is left out.
std::vector<PlanArea> plan_areas(const LayerModel& model,
                                 const std::function<std::size_t(std::size_t face)>& label);

//! The outline of the whole plan.
std::vector<std::vector<Point2>> plan_outline(const LayerModel& model);

//! The geological map: the areas in which each layer is the topmost one. Label = layer.
std::vector<PlanArea> geological_map(const LayerModel& model);

}  // namespace stratareeb
