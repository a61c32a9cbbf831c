// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "subdivision/plan_cells.h"

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

}  // namespace stratareeb
