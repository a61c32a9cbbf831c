// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "boreholes/validation.h"
#include "io/write_features.h"
#include "io/write_table.h"
#include "mesh/layer_volumes.h"

namespace stratareeb {

//! One way to predict, and how it did.
struct NamedValidation {
    std::string name;  // of the interpolator
    Validation result;
};

//! What a hold-out was, in words and numbers, for reports.
struct ValidationRecord {
    std::string hold_out;  // "10 folds, seed 1"
    double confidence = 0.95;
    std::string law = "t";
    std::vector<std::string> warnings;
};

//! Everything but the residuals, as one JSON object for each interpolator in `interpolators`.
nlohmann::ordered_json validation_json(const Survey& survey, const std::vector<NamedValidation>& validations,
                                       const ValidationRecord& record);

//! A row for each layer's thickness and each horizon's elevation, for all interpolators.
OutputTable errors_table(const std::vector<NamedValidation>& validations);

//! A row for each held-out number: hole, place, draw, item, actual, predicted, error, interval.
OutputTable residuals_table(const Survey& survey, const NamedValidation& validation);

//! The same as points on the map.
std::vector<MapFeature> residual_features(const Survey& survey, const NamedValidation& validation);

//! Length of each unit drilled (rows) that was predicted as each unit (columns); the last column is below the model.
OutputTable unit_match_table(const Survey& survey, const NamedValidation& validation);

OutputTable next_boreholes_table(const NamedValidation& validation);

//! True and modelled volumes side by side with errors in per cent, as in the thesis's section 4.1.4.3.
OutputTable volumes_table(const TrueVolumes& truth, const std::vector<ComparedModel>& models);
nlohmann::ordered_json volumes_json(const TrueVolumes& truth, const std::vector<ComparedModel>& models);

}  // namespace stratareeb
