// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"

namespace stratareeb {

//! How a model was predicted, as far as the options of its record say: interpolator (`auto`: chosen anew), pinch-out rule, and
//! the ground's raster if its file is still there.
CompletionOptions model_prediction(const Survey& survey, const std::map<std::string, std::string>& options);

}  // namespace stratareeb
