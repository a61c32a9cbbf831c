// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/rim_sides.h"

namespace stratareeb {

//! The faces, edges and corners that bound the bodies of a layer model, and how they hang together: a boundary
//! representation without geometry yet. All of it stands over the plan: faces between layers over plan
//! triangles, edges over lines of plan edges, corners over plan vertices, walls over the sides of the rim.
struct PlanCells {
    static constexpr std::uint32_t kNone = ~0u;

    struct EdgeUse {
        std::uint32_t edge;
        bool forward;
    };
    using Loop = std::vector<EdgeUse>;  // closed, each edge starts where the last one ended

    //! A point that bounds edges, named after the highest of the horizons that meet there.
    struct Corner {
        std::uint32_t vertex, horizon;
    };

    //! A run of plan edges along which the same cells meet. On the rim, the plan's inside is on the left.
    struct Line {
        std::vector<std::uint32_t> vertices;
        std::uint32_t side = kNone;  // of the rim
    };

    //! On a horizon along a line, or upright along a layer's wall at the end of a side.
    struct Edge {
        std::uint32_t line = kNone;  // kNone = upright
        std::uint32_t horizon = 0;   // the highest of those that meet there; unused if upright
        std::uint32_t from = 0, to = 0;
        std::vector<std::uint32_t> cells;  // that meet there
    };

    //! A connected part of the plan over which one layer lies directly on another. The face there is shared by
    //! the two bodies that it parts.
    struct Cell {
        std::uint32_t horizon = 0;                             // one of those that run along it
        std::uint32_t body_above = kNone, body_below = kNone;  // kNone = air; nothing
        std::vector<std::uint32_t> faces;                      // plan triangles, ascending
        std::vector<Loop> loops;                               // the cell on the left, seen from above
    };

    //! A part of a body's boundary over one side of the rim. The loop is counter-clockwise from outside.
    struct Wall {
        std::uint32_t side = 0;
        Loop loop;
    };

    //! A connected part of a layer: its top and base are cells.
    struct Body {
        std::uint32_t layer = 0;
        std::vector<std::uint32_t> faces;  // plan triangles, ascending
        std::vector<std::uint32_t> top, base;
        std::vector<Wall> walls;
    };

    std::vector<Corner> corners;
    std::vector<Line> lines;
    std::vector<Edge> edges;
    std::vector<Cell> cells;
    std::vector<Body> bodies;  // layer by layer from the top
    std::vector<RimSide> sides;
};

struct PlanCellsOptions {
    RimSidesOptions rim;
    double corner_deg = 35;  // inner lines that turn by more are cut there
};

//! \pre regions as build_layer_regions makes them: a body does not touch itself.
PlanCells build_plan_cells(const LayerModel& model, const PlanCellsOptions& options = {});

}  // namespace stratareeb
