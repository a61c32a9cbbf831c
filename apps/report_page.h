// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

#include "apps/report_options.h"

namespace stratareeb {

//! What became of a report.
struct ReportPage {
    std::size_t figures = 0, bytes = 0;
};

//! Write one page about the model in a folder, with all its figures, linked to the 3D page that stands beside it (or will, if
//! `has_view`).
//! \throw IoError as read_model and write_aside do
ReportPage write_report_page(const std::filesystem::path& folder, const std::filesystem::path& file,
                             const ReportChoices& choices, Progress& progress, bool has_view = false);

}  // namespace stratareeb
