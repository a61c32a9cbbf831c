// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"
#include "boreholes/choose_interpolator.h"
#include "io/smooth_bodies.h"
#include "mesh/layer_model.h"
#include "mesh/model_summary.h"
#include "subdivision/smoothness.h"

namespace stratareeb {

//! What stands in model.json beside the model itself.
struct ModelRecord {
    std::vector<UnitSummary> units;  // top first
    std::vector<ModelCheck> checks;
    std::vector<std::string> warnings;                // from the table's audit and the completion
    std::map<std::string, std::string> options;       // as used, by name
    std::string crs = {};                             // of map coordinates, "EPSG:27700" or WKT; may be empty
    std::vector<std::string> files;                   // all files of the folder, relative
    std::optional<SmoothnessReport> smoothness = {};  // of refined surfaces
    std::optional<InterpolatorChoice> choice = {};    // by `auto`: all candidates' errors
    //! By unit, the files of its solids where a model has faults: one a block.
    std::vector<std::vector<std::string>> solids = {};
    std::vector<SmoothBodyReport> cad = {};  // of `--step smooth`
};

//! Folders of a model's surfaces, and of those that refinement began with.
constexpr const char *kHorizonsFolder = "horizons/", *kUnrefinedFolder = "unrefined/";

//! Two digits or more, an underscore and the name in letters that any file system takes: "03_made_ground".
std::string numbered_name(std::size_t number, const std::string& name);

//! model.json's text: see docs/build.md for its keys.
std::string model_json(const LayerModel& model, const Survey& survey, const ModelRecord& record);

}  // namespace stratareeb
