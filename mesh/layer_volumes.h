// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! Volume between the horizons of each layer, top first: what its solid holds, without the solid being made.
std::vector<double> layer_volumes(const LayerModel& model);

//! What the layers of a place truly hold.
struct TrueVolumes {
    Footprint footprint;             // of the model that is compared
    std::vector<std::string> codes;  // of the layers, top first
    std::vector<double> volumes;
};

//! One model beside the truth.
struct ComparedModel {
    std::string name;
    std::size_t holes = 0;
    std::vector<double> volumes;  // of the truth's layers; 0 for one that the survey does not know
    double envelope = 0;
};

//! Build a model of a survey over the footprint of the truth and take its volumes.
//! \throw InvalidInput if the survey has a unit that the truth lacks, and as build_layer_model does
ComparedModel compare_volumes(const std::string& name, const Survey& survey, const TrueVolumes& truth,
                              LayerModelOptions options);

}  // namespace stratareeb
