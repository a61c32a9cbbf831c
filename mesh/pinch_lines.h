// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boreholes/thickness_field.h"

namespace stratareeb {

//! Line work in plan: points without repeats and the pieces that join them.
struct PlanLines {
    std::vector<Point2> points;
    std::vector<std::array<std::uint32_t, 2>> segments;
};

//! The pinch-out lines of all layers: the level sets share = fraction of a ThicknessField, cut where two of
//! them cross. Points are shared: layers that end between the same two holes end at the same point, to the
//! last bit. Beyond the holes' hull, lines go on square to the hull edge, `reach` long.
PlanLines pinch_lines(const ThicknessField& field, double reach);

//! The edges of the holes' triangulation, cut at the points in which pinch-out lines meet them: with
//! pinch_lines, the line work of the bare triangulation of the thesis.
PlanLines cut_triangulation_edges(const ThicknessField& field);

}  // namespace stratareeb
