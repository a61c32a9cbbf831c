// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Directed borders of areas, the area on their left, joined to rings of point numbers. Where several rings meet in a point,
//! they are kept apart: each turns to the left as far as it can, so that no ring touches itself.
//! \pre every point has as many borders coming in as going out.
std::vector<std::vector<std::uint32_t>> stitch_rings(std::span<const Point2> points,
                                                     std::vector<std::array<std::uint32_t, 2>> borders);

//! Positive if counter-clockwise.
double ring_area(std::span<const Point2> ring);

//! Outer rings with the holes that lie in each: [outer, hole, hole, …]. A hole belongs to the smallest outer ring around it.
std::vector<std::vector<std::vector<Point2>>> nest_rings(std::vector<std::vector<Point2>> rings);

}  // namespace stratareeb
