// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>

#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

//! Lines inside the plan whose curves cross one another, or the rim, around a cell: its outline would be no outline. Looked for at
//! a few places of each span.
std::set<std::uint32_t> crossed_lines(const PlanCells& cells, const PlanCurves& curves);

}  // namespace stratareeb
