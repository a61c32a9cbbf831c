// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! What lies inside an odd number of closed rings, as triangles between their corners. Rings may touch themselves and one another in
//! corners, and have whole sides in common: a side that two of them have is no border. Where two equal rings lie on one another
//! nothing is left.
//! \param corners places, each once
//! \param rings closed, as numbers of corners
//! \return triangles of a constrained Delaunay triangulation, counter-clockwise, in a fixed order
//! \throw InvalidInput if two corners have one place, or a side crosses another or passes through a corner; the message names the place.
std::vector<std::array<std::uint32_t, 3>> ring_fill(std::span<const Point2> corners,
                                                    std::span<const std::vector<std::uint32_t>> rings);

}  // namespace stratareeb
