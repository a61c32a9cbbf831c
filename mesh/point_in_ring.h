// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Does a closed ring, in either sense and without its first point repeated, lie around a point in plan? Even-odd rule, by a ray to the right; on the
//! ring itself either answer. `Point`: Point2, or Point3, whose z doesn't count.
template <class Point>
bool is_inside_ring(const std::vector<Point>& ring, const Point& p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

}  // namespace stratareeb
