// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

//! Where the lines of the plan's cells would have to run for the sheets that meet there to be as far apart as their gaps are: each vertex
//! of a line, moved across it (ends on the rim along it; other ends stay, but for junctions of up to three lines with a gap) to where the
//! base of the body that ends there is that far below the sheet above, by damped Gauss-Newton steps. They move by no more than a
//! quarter of the way to the next vertex.
LineMoves snapped_lines(const TriMesh& plan, const PlanCells& cells, const PlanCurves& curves,
                        const HorizonSheets& sheets, double size);

}  // namespace stratareeb
