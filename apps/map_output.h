// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/write_features.h"
#include "io/write_plan_map.h"

namespace stratareeb {

//! A map of a model with its outline, legend of all units, and boreholes, ready for areas and lines.
PlanMap map_of(const SavedModel& saved, const std::string& title);

//! Areas with their unit as polygons for GIS.
std::vector<MapFeature> area_features(const std::vector<MapArea>& areas, const std::vector<Unit>& units);

//! The unit of a code or name, or its number from 1.
//! \throw InvalidInput naming the model's units
std::size_t unit_by_name(const LayerModel& model, const std::string& name);

}  // namespace stratareeb
