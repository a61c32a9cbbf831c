// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/hole_triangulation.h"

namespace stratareeb {

//! Each place as it is where it lies in the sites' hull, the closest point of the hull where it does not.
std::vector<Point2> closest_in_hull(const HoleTriangulation& holes, std::span<const Point2> where);

//! The same, but places up to `reach` away from the hull as they are, and farther ones where the way from the closest point of
//! the hull to them has come so far.
std::vector<Point2> closest_in_reach(const HoleTriangulation& holes, std::span<const Point2> where,
                                     double reach);

}  // namespace stratareeb
