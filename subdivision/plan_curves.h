// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/plan_cells.h"
#include "subdivision/spline_fit.h"

namespace stratareeb {

//! One wall's course in plan.
struct SideCurve {
    bool straight = true;
    Point2 from, to;
    SplineCurve curve{CubicKnots({0, 1}), {}};  // x, y over the length along the vertices; unless straight
};

//! A line of cells as a curve in plan.
struct LineCurve {
    SplineCurve curve{CubicKnots({0, 1}), {}};  // x, y
    std::vector<double> parameters;             // of the line's vertices
    double side_start = 0;                      // of parameter 0 on the side's curve, on the rim
};

struct PlanCurves {
    std::vector<SideCurve> sides;  // [cells.sides]
    std::vector<LineCurve> lines;  // [cells.lines]
};

//! Places that vertices of lines are to have instead of their own.
struct LineMoves {
    std::map<std::uint32_t, Point2> inner;  // by vertex
    std::map<std::pair<std::uint32_t, std::uint32_t>, double>
        on_side;                          // by side and vertex: the length up to it
    std::map<std::uint32_t, int> closer;  // by line: how many times to fit it ten times as closely
};

//! Smooth curves within a tolerance of the vertices of sides and lines. Lines on a side are exactly parts of
//! its curve, and lines that meet at a vertex meet in one point.
PlanCurves build_plan_curves(const TriMesh& plan, const PlanCells& cells, double tolerance,
                             const LineMoves& moves = {});

}  // namespace stratareeb
