// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Cut off what makes a closed line cross or touch itself in plan: at each crossing the shorter of the two parts goes, unless it is
//! longer than a share of the whole. For meshes that cross themselves a little, as scans and CAD exports do.
//! \return is the line simple now? Else it is as it was.
bool cut_crossings(std::vector<Point3>& points, double most_share);

}  // namespace stratareeb
