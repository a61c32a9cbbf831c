// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A closed curve of numbered points.
using PointLoop = std::vector<std::uint32_t>;

//! The contours on the other side of a critical level: where contours touch in critical points, from one side, they run together there
//! into pieces; seen from the other side, each piece goes on with another one. Two contours side by side become one, and so do a
//! contour and its hole; one contour that passes a point twice becomes two.
//!
//! \param contours those of one side, counter-clockwise, each through critical points once or oftener
//! \param is_hole by contour: the solid is outside of it
//! \param points places of numbered points; their x and y count
//! \return counter-clockwise curves through the critical points; none if the directions at a point allow no answer, as where
//! contours cross there.
std::optional<std::vector<PointLoop>> contours_across(std::span<const PointLoop> contours,
                                                      const std::vector<bool>& is_hole,
                                                      const std::set<std::uint32_t>& critical,
                                                      std::span<const Point3> points);

//! Twice the area that a closed curve encloses in plan, positive if it runs counter-clockwise.
double twice_plan_area(std::span<const std::uint32_t> loop, std::span<const Point3> points);

}  // namespace stratareeb
