// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/progress.h"
#include "io/read_record.h"
#include "io/report_figures.h"

namespace stratareeb {

//! What `report` and `deliver` are told alike.
struct ReportChoices {
    std::string title;
    std::vector<std::string> fences;  // each HOLE,HOLE,…
    std::uint64_t seed = 1;
    bool no_validation = false;
};

void add_report_options(CLI::App& command, ReportChoices& choices);

//! As options of the drawings; `progress` must outlive them.
ReportOptions report_options(const ReportChoices& choices, const SavedRecord& record, Progress& progress);

}  // namespace stratareeb
