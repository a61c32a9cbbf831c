// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Cut faces of many spans into strips along lines of equal x, the same lines in all sheets where that is possible. CAD programs
//! integrate a volume face by face with a fixed number of points from side to side (OpenCASCADE: 61), too few for a
//! hundred spans. Strips of a sheet meet in curves of it, exactly.
//! \param sheets [sheet] whose faces are to be cut
//! \param spans of a strip
//! \throw GeometryError if an edge only touches a line; the faces are cut in part then.
void cut_into_strips(SmoothBrep& brep, const std::vector<char>& sheets, std::size_t spans = 14);

}  // namespace stratareeb
