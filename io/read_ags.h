// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "boreholes/hole_log.h"
#include "io/collars.h"
#include "io/table_context.h"

namespace stratareeb {

//! Holes and strata of AGS files, with what the files call the units.
struct AgsLogs {
    LogSet logs;
    std::map<std::string, std::string> unit_names;  // code → description, from the group ABBR
};

//! Read the groups HOLE (edition 3) or LOCA (edition 4) and GEOL of one or more AGS files as one set: a hole's place may stand in
//! one file and its strata in another. Units are the codes of the heading that `--columns unit=` states, otherwise of GEOL_GEOL,
//! GEOL_GEO2, GEOL_LEG or GEOL_FORM, the first that half of all rows fill. Places are national grid coordinates; local ones
//! (LOCX, LOCY, LOCZ) where no hole has others. `collars` gives the places of holes that have none in the files. Findings go to
//! the audit: they name file, line, heading, group and value.
AgsLogs read_ags(const std::vector<std::string>& sources, const CollarTable* collars, TableContext& context);

}  // namespace stratareeb
