// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/read_model.h"

namespace stratareeb {

//! What `section` is told.
struct SectionArguments {
    std::string folder, title, crs;
    std::vector<std::string> outputs, through;
    std::vector<double> along;
    std::optional<double> at_z;
    double exaggeration = 0, holes_within = -1;
    bool critical = false, json = false, overwrite = false;
};

//! Horizontal sections as maps: the one at `at_z`, or one at each critical height. Of several, drawings get numbers
//! (level.svg: level_01.svg, …) and polygons for CAD and GIS stand in one file, each at its height.
//! \throw InvalidInput if nothing of the model lies at `at_z`
void run_level_sections(const SectionArguments& arguments, const SavedModel& saved);

}  // namespace stratareeb
