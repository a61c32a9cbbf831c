// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Lines of equal x along which faces are to be cut so that each half has half of the spans: clear of corners and turns of
//! edges by some of a span; where another face was cut nearby, if there is room.
//! \param which [brep.cells.cells] whether to cut it
//! \return [brep.cells.cells] x; NAN = not to be cut, too narrow, or there is no room
std::vector<double> halving_lines(const SmoothBrep& brep, const std::vector<char>& which);

}  // namespace stratareeb
