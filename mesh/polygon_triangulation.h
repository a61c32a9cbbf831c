// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! The inside of a simple polygon as triangles between its corners: the constrained Delaunay triangulation, which among
//! all has the largest least angle. Triangles run counter-clockwise, whichever way the polygon runs.
//! \throw InvalidInput if the polygon crosses or touches itself.
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Point2> corners);

}  // namespace stratareeb
