// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/read_record.h"
#include "io/report_figures.h"

namespace stratareeb {

//! What a report is made of.
struct ReportParts {
    const SavedModel& saved;
    const SavedRecord& record;
    const ReportFigures& figures;
    std::string title;                 // empty = "Layer model"
    std::vector<std::string> links{};  // files beside it to point to, such as "model.html"
};

//! One HTML page for people, readable on any screen and printable: what went in, the layers, volumes, checks, sections, maps,
//! validation, Reeb graphs, options. No scripts; nothing is fetched from elsewhere.
//! `source`: a figure's address in the page: its path, or a data URL.
std::string report_html(const ReportParts& parts,
                        const std::function<std::string(const std::string& file)>& source);

}  // namespace stratareeb
