// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Cut faces of many spans into two strips each, along a line of equal x. CAD programs integrate a volume face by face with
//! a fixed number of points from side to side (OpenCASCADE: 61), too few for a hundred spans. Strips of a sheet meet in
//! curves of it, exactly.
//! \param which [brep.cells.cells] whether to cut it; those of less than four spans stay whole. The first strip keeps the
//! number.
//! \return how many were cut: none if an edge only touches a line
std::size_t halve_cells(SmoothBrep& brep, const std::vector<char>& which);

}  // namespace stratareeb
