// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A place well inside the region of closed rings in the plane (what an odd number of rings is around): as far from all rings
//! as it can be, to a tenth of that distance (its "pole of inaccessibility", found by squares cut in four as V. Agafonkin
//! describes). A centroid may lie outside; this never does. Thin regions get, after some
//! thousand squares, the best place so far.
//! \pre the rings enclose an area and don't cross
Point2 inner_point(std::span<const std::vector<Point2>> rings);

}  // namespace stratareeb
