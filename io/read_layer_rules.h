// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/layer_rules.h"

namespace stratareeb {

//! A table of units and their rules: columns `code`, `rule` and `min_thickness` by name, in any order; other columns are
//! left alone, empty cells say nothing. Any format that read_tables takes.
//! \throw IoError if it can't be opened; InvalidInput that names line and cell for a missing column, an unknown rule or
//! a minimum that is no length
std::vector<NamedRule> read_layer_rules(const std::string& path);

}  // namespace stratareeb
