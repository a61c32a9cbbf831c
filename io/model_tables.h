// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"
#include "io/read_record.h"
#include "io/write_table.h"

namespace stratareeb {

//! A row for each layer: order, code, name, colour, volume, area in plan, mean and largest thickness, bodies, what holes say. The
//! columns' names have the unit of length: "volume_m3".
OutputTable volumes_table(const LayerModel& model, const SavedRecord& record);

//! A row for each interval that a hole found itself: hole, place, layer, top and base as elevations, thickness, and whether the
//! hole ended in it. Layers whose top and base are not both known are left out.
OutputTable logs_table(const Survey& survey);

//! A row for each hole and layer: the same for the model's column at the hole's place, absent layers with thickness 0. Holes outside
//! the footprint are left out.
OutputTable model_logs_table(const SavedModel& saved);

}  // namespace stratareeb
