// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "boreholes/point.h"

namespace stratareeb {

struct ClosestPair {
    std::size_t first = 0, second = 0;  // indices into the two sets
    double distance = 0;
};

//! The pair, one point of each set, with the smallest distance (thesis 2.1.2.2.4, over all pairs).
//! Of equally close pairs the one whose points come first by x, then y, then index: how the sets are numbered does not matter
//! as long as no two points coincide. About n log n for points along curves (k-d tree over the second set).
//! \pre Neither set is empty; all coordinates are finite.
ClosestPair closest_pair(std::span<const Point2> first, std::span<const Point2> second);

//! The same for places on a circle of perimeter 1, both ascending in [0, 1): the thesis's parametric distance |s - t|,
//! taken the shorter way round, so that it does not depend on where a contour's parameters start. Linear time.
ClosestPair closest_parameters(std::span<const double> first, std::span<const double> second);

}  // namespace stratareeb
