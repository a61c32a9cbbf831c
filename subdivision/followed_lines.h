// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

//! Inner lines where a body ends, bent between their vertices too, to where its base is its gap below the sheet above.
//! They have as many spans as that needs, their ends and parameters stay, and no place moves by more than a quarter of the way to
//! the next vertex. Lines where more than two sheets meet stay: one line can't follow two gaps; so do those that would wind.
//! \param size of the model
//! \return [cells.lines]
std::vector<SplineCurve> followed_lines(const PlanCells& cells, const PlanCurves& curves,
                                        const HorizonSheets& sheets, double size);

}  // namespace stratareeb
