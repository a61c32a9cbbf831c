// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A level contour that bounds a sheet.
struct SheetRing {
    std::vector<Point3> points;  // counter-clockwise
    bool is_lower = false;       // the sheet rises from it
    bool is_hole = false;        // the solid is outside of it
};

//! Points by numbers: those of the rings, ring by ring, then added ones.
struct PlanSheet {
    std::vector<Point3> added;
    std::size_t critical = 0;  // how many of the added ones, the first, are critical points
    std::vector<std::array<std::uint32_t, 3>> triangles;  // facing away from the solid
};

//! The surface between neighbouring contours, where none of them crosses another in plan and they lie around one connected region:
//! one height for each place of the region, so that it can't cross itself, nor another sheet of such a kind. The region is
//! triangulated with points inside, about `steps` across. Heights rise from lower to upper contours and have no minimum, maximum or saddle but the
//! node. One ring and a node: a cap, which holds what a half ellipsoid does. One lower and one upper ring, no node: a band. Several rings of one side, one of the other and a
//! node: what branches there; more than two contours that no point lies between meet across the gaps between them instead, at the node's
//! height (see contour_touches).
//! \return nothing where contours aren't level, cross or touch in plan, don't lie around one region with the node inside, or where triangles
//! leave no room
std::optional<PlanSheet> plan_sheet(std::span<const SheetRing> rings, const std::optional<Point3>& node,
                                    std::size_t steps);

}  // namespace stratareeb
