// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"

namespace stratareeb {

//! Drop holes that lie absurdly far from the others (a mistyped coordinate): more than 20 times as far from
//! the median place as nine tenths of the holes are. One warning each, with the row in `file`. Needs at least
//! 5 holes.
void drop_far_holes(Survey& survey, const std::string& file, Audit& audit);

//! Leave one hole at each place (within 1e-9 of the extent): the one that knows most layers, then the deeper,
//! then the first. A warning names the rows and says whether the logs were identical.
void merge_same_place(Survey& survey, const std::string& file, Audit& audit);

//! An error if the holes don't span an area: fewer than three places, or all on one line (within 1e-6 of
//! their extent). For footprints made from the holes; a footprint from a file needs no such holes.
void check_plan_layout(const Survey& survey, Audit& audit);

}  // namespace stratareeb
