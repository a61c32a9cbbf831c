// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/report_options.h"

namespace stratareeb {

struct DeliverArguments {
    std::string folder;  // that `build` wrote
    std::string output;  // the folder to hand over
    std::string crs = {};
    ReportChoices choices = {};
    bool overwrite = false, quiet = false;
};

//! Write the folder to hand over: report, sections, maps, tables, and the model's files.
//! \throw what read_model and write_report_figures throw; IoError if the output holds something and may not be overwritten
void deliver(const DeliverArguments& arguments);

}  // namespace stratareeb
