// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Two edges of closed rings that cross, touch or overlap. Edge i of a ring leads from its corner i to the next.
struct RingCrossing {
    std::uint32_t ring = 0, edge = 0, other_ring = 0, other_edge = 0;
    Point2 place;  // near it: the first edge's start
    bool operator==(const RingCrossing&) const = default;
};

struct RingCrossingOptions {
    bool shared_corners =
        false;  // rings may touch themselves and one another where corners are the same point
    std::size_t most = ~std::size_t{0};  // stop after so many
};

//! Where closed rings in the plane cross themselves or one another, decided exactly. The corner between neighbouring edges
//! is no crossing, unless the ring turns back on itself there. Rings don't repeat their first corner.
//! Time: O(n log^2 n) and the number of edge pairs whose boxes meet.
//! \return in order of rings and edges
std::vector<RingCrossing> ring_crossings(std::span<const std::vector<Point2>> rings,
                                         const RingCrossingOptions& options = {});

}  // namespace stratareeb
