// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "reeb/level_set.h"

namespace stratareeb {

//! A region between contours: an outer ring and the rings of its holes.
struct ContourPolygon {
    std::uint32_t outer = 0;
    std::vector<std::uint32_t> holes;
};

//! Which contours of a level set lie in which. Contours are named by their place in the set.
struct ContourNesting {
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::uint32_t> parent;  // by contour: the innermost closed one around it, or kNone
    std::vector<std::uint32_t> depth;   // by contour: how many closed ones lie around it
    std::vector<ContourPolygon>
        polygons;  // one for each closed contour of even depth; its holes are that one's children
    std::vector<std::uint32_t> open;  // contours that end on the boundary: without parent, in no polygon
};

//! Nest the closed contours of a level set of height along a direction, seen from its tip. Where contours touch, at a vertex
//! or along a ridge of exactly that height, the answer is that for the level just below, as the contours run there: a ring
//! and its hole that both have shrunk to one ridge are still nested. (Rings alone in the plane that are shared whole are taken
//! to be of a surface wound outward, and touching rings beside open contours of one that faces the direction.) Contours that
//! cross, as those of a surface that intersects itself may, get some forest, the same in every run.
//! Time: the number of points, and for each contour the number of segments above or below one of its points.
//! \throw InvalidInput if the direction is zero or not finite.
ContourNesting nest_contours(const LevelSet& set, const Point3& direction = {0, 0, 1});

//! Area of the polygons with holes, seen along the direction: for a closed surface that of its section.
double enclosed_area(const LevelSet& set, const ContourNesting& nesting, const Point3& direction = {0, 0, 1});

}  // namespace stratareeb
