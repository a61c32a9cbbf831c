// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "boreholes/choose_interpolator.h"
#include "io/write_table.h"

namespace stratareeb {

//! What was compared to choose an interpolator: `interpolator`, `reason`, and for each quantity the number of held-out holes and the
//! RMSE of each candidate.
nlohmann::ordered_json choice_json(const InterpolatorChoice& choice);

//! A row for each quantity, a column for each candidate's RMSE; the last row has their ratios to the first.
OutputTable choice_table(const InterpolatorChoice& choice);

//! The same for people, with the reason below.
std::string choice_text(const InterpolatorChoice& choice);

}  // namespace stratareeb
