// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "boreholes/hole_triangulation.h"
#include "boreholes/point.h"

namespace stratareeb {

//! The plan outline of a model: closed rings without a repeated last point, outer ones counter-clockwise,
//! holes clockwise.
using Footprint = std::vector<std::vector<Point2>>;

//! The hull of the holes.
//! \throw InvalidInput if all holes stand in a line (needs a box or a polygon).
Footprint hull_footprint(const HoleTriangulation& holes);

//! The bounding box of the holes, wider by `margin` on each side.
//! \throw InvalidInput if the box has no area.
Footprint box_footprint(const std::vector<Point2>& holes, double margin);

//! A margin that suits the holes: half of their mean spacing in the hull, or a tenth of their extent if they
//! stand in a line.
double suitable_margin(const HoleTriangulation& holes);

//! Even-odd rule; places on a ring may go either way.
bool is_inside(const Footprint& footprint, const Point2& p);

double area(const Footprint& footprint);

//! Rings made usable: repeated points dropped, outer rings turned counter-clockwise and holes clockwise.
//! \throw InvalidInput with the place, if a ring has fewer than three corners, no area, or crosses itself or
//! another.
Footprint checked_footprint(Footprint footprint);

//! Points within `tolerance` of a ring become corners of it, so that none stays so close to an edge that only
//! slivers fit between.
Footprint with_points_on_rings(const Footprint& footprint, const std::vector<Point2>& points,
                               double tolerance);

}  // namespace stratareeb
