// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A contour at the edge of the region between two levels.
struct CellRing {
    std::vector<Point2> points;
    bool is_lower = false;  // of the lower level
};

//! An edge between critical points, or between one and a ring; contours between its ends, bottom to top.
struct CellEdge {
    std::uint32_t from = 0, to = 0;  // rings by number, then nodes
    std::vector<std::vector<Point3>> contours;
};

struct CellGraph {
    std::vector<Point3> nodes;
    std::vector<CellEdge> edges;
};

//! How several contours of one level become several of the next, none of which crosses another: as on the surface over the plan that has
//! their heights and harmonic ones between, which has saddles and no other critical points.
//! \return nothing where no such surface was found: triangles leave no room, or saddles come out at one height
std::optional<CellGraph> cell_graph(std::span<const CellRing> rings, double low, double high);

}  // namespace stratareeb
