// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! For each point of a contour, how a cap is to go on there, d width / d x (see CapProfile::conic), so that cap and surface have one
//! tangent plane: what lies along the contour doesn't count. If the contour can't be seen whole from its targets, the slope of the width
//! in the mean of squares for all points, which keeps the cap's rows from crossing themselves.
//! \param targets  where each point goes to; points of the contour and targets in plan
//! \param beside   where the surface has each point a little beyond the contour
//! \param share    the height to there, as a share of the cap's
std::vector<double> cap_slopes(std::span<const Point3> contour, std::span<const Point3> targets,
                               std::span<const Point3> beside, double share);

}  // namespace stratareeb
