// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "boreholes/point.h"

namespace stratareeb {

//! How far a contour's points are from one another, but not more than a 96th of it or a 6th of its width: what is shorter doesn't show.
double point_spacing(std::span<const Point3> contour);

//! Bands between two contours, or a contour and a point, that are `gap` apart: no more than `most`, and, from `least` on, none lower than
//! 3 / steps of the spacing of their points, half of it for six steps: lower ones would show nothing.
std::size_t bands_across(double gap, double spacing, std::size_t steps, std::size_t least, std::size_t most);

}  // namespace stratareeb
