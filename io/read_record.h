// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/write_model.h"

namespace stratareeb {

//! What model.json says beside the model itself, for reports.
struct SavedRecord {
    ModelRecord record;  // of its units' numbers: those in model.json
    Misfit misfit;
    double envelope_volume = 0;
};

//! Read the record of a folder that `build` wrote.
//! \throw IoError, or InvalidInput naming file and place
SavedRecord read_record(const std::filesystem::path& folder);

}  // namespace stratareeb
