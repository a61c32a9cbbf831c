// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "io/write_validation.h"

namespace stratareeb {

//! Maps of the errors, a panel for each layer (for contact points, each horizon): circles whose area grows with the error, blue
//! where too much was predicted and red where too little, hollow outside the hull of the holes that were left; crosses
//! where further boreholes would help most. At most 24 panels, those of the largest errors.
//! \throw IoError if the extension is not .svg, .pdf or .png or the file can't be written
void write_residual_map(const std::filesystem::path& file, const Survey& survey,
                        const NamedValidation& validation);

//! Predicted against actual with intervals, a panel for each.
//! \throw IoError likewise
void write_residual_scatter(const std::filesystem::path& file, const Survey& survey,
                            const NamedValidation& validation);

}  // namespace stratareeb
