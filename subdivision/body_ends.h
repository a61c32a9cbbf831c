// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

//! An edge along which a body ends: its base meets a sheet further up there.
struct BodyEnd {
    std::uint32_t edge;   // of the cells
    std::uint32_t above;  // the lowest of the sheets of higher layers there
};

//! \param of_cell the sheet of each cell: 0 = the ground, 1 + body = the base of a body.
//! \return [body]
std::vector<std::vector<BodyEnd>> body_ends(const PlanCells& cells,
                                            const std::vector<std::uint32_t>& of_cell);

//! Lower bases along the curves where their bodies end, by as little as does, until none lies higher than half its gap below
//! the sheet above: where sheets cross inside a body, CAD programs find a new edge beside the one that ends it.
//! Thicknesses are measured anew.
void open_body_ends(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                    const PlanCurves& curves);

}  // namespace stratareeb
