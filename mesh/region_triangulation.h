// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A closed ring in the plane that bounds a region, and the kind of thing it is: rings of one side are to stay apart.
struct RegionRing {
    std::vector<Point2> points;  // in either sense, the first not repeated
    std::uint32_t side = 0;
};

//! A point inside a region.
struct RegionPoint {
    Point2 place;
    double size = std::numeric_limits<double>::infinity();  // of edges around it, at most
};

struct RegionTriangulationOptions {
    double largest_edge =
        std::numeric_limits<double>::infinity();  // roughly, where rings' own edges are not shorter
    std::size_t most_added = 200'000;             // points for size; others are added as needed
};

//! Triangles by numbers: points of the rings, ring by ring, then those inside, then those that were added.
struct RegionTriangulation {
    std::vector<Point2> added;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise
};

//! The region that an odd number of rings lies around, as a Delaunay triangulation that has all edges of the rings and
//! points between them: as close as the rings' corners beside them, growing away from them. Rings get no new points. No edge inside the
//! region joins two points of rings of the same side, so that a function that is constant on each side is constant on no triangle.
//! \param inside further points, strictly inside the region
//! \throw InvalidInput if rings cross or touch, or a point is not inside or given twice.
RegionTriangulation triangulate_region(std::span<const RegionRing> rings, std::span<const RegionPoint> inside,
                                       const RegionTriangulationOptions& options = {});

}  // namespace stratareeb
