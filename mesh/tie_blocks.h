// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/fault_blocks.h"

namespace stratareeb {

//! Find the ties of blocks whose outlines, holes and ways on are known: along each way on, to both sides of it, for both of its
//! blocks, so that surfaces go on across it at the height and with the slope they have.
//! \param hole_gap between neighbouring holes, as a mean
void tie_blocks(FaultBlocks& blocks, double hole_gap);

//! How far from a way on a place may be that is on it.
double way_on_tolerance(const FaultBlocks& blocks);

}  // namespace stratareeb
