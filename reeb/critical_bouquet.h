// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A closed curve of numbered points.
using PointLoop = std::vector<std::uint32_t>;

//! The contours on the other side of a critical point: where contours touch in it, from one side, they run together there
//! into loops; seen from the other side, each loop goes on with another one. Two contours side by side become one, and so do a
//! contour and its hole; one contour that passes the point twice becomes two.
//!
//! \param contours those of one side, counter-clockwise, each through the critical point once or oftener
//! \param is_hole by contour: the solid is outside of it
//! \param points places of numbered points; their x and y count
//! \return counter-clockwise curves through the critical point; none if the directions at the point allow no answer, as where
//! contours cross there.
std::optional<std::vector<PointLoop>> contours_across(std::span<const PointLoop> contours,
                                                      const std::vector<bool>& is_hole,
                                                      std::uint32_t critical, std::span<const Point3> points);

//! Twice the area that a closed curve encloses in plan, positive if it runs counter-clockwise.
double twice_plan_area(std::span<const std::uint32_t> loop, std::span<const Point3> points);

}  // namespace stratareeb
