// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "reeb/height_scale.h"
#include "reeb/homotopy_weights.h"
#include "reeb/mesh_contours.h"

namespace stratareeb {

struct ContourRefinement {
    HomotopyKind homotopy = HomotopyKind::Cardinal;
    double tolerance = 0;    // > 0: how far the homotopy half way may be from the contour there, in plan
    std::size_t most = 200;  // contours
};

//! Is there room for a contour between heights of an edge from `bottom` to `top`? Closer ones would be rounding, and edges would not rise.
bool has_room(double low, double high, double bottom, double top);

//! More contours of an edge, half way between neighbours, where what the homotopy makes there crosses itself (four times at most:
//! contours may crowd so that no number of them helps) or is too far from the truth. The whole edge is gone through once, then where that
//! was not enough, so that no place takes the room of others.
//! \param at the contour of the edge at a height
//! \pre one contour at least; heights ascend
void refine_contours(std::vector<LevelContour>& contours, const HeightScale& scale,
                     const std::function<LevelContour(double)>& at, const ContourRefinement& options);

}  // namespace stratareeb
