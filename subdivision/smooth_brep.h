// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "subdivision/height_patch.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"
#include "subdivision/spline_fit.h"

namespace stratareeb {

//! The bodies of a layer model as few smooth faces: a bicubic B-spline patch for each cell, trimmed by cubic
//! B-spline edges, and upright walls. Each curve in plan is its own curve in a patch's parameters, so that faces
//! and edges differ in height only, by no more than the tolerances here say.
struct SmoothBrep {
    struct Corner {
        Point3 at;
        double tolerance = 0;  // edges and patches end no further away
    };

    //! x, y, z over a parameter; a line between its corners where it is upright.
    struct Edge {
        SplineCurve curve{CubicKnots({0, 1}), {}};
        double tolerance = 0;   // patches and curve are no further apart
        double side_start = 0;  // on the rim: its beginning on its side, whose parameter goes on from there
    };

    struct BodyQuality {
        double mesh_volume = 0;  // of the model's triangles
        double least_thickness =
            0;           // top above base, at plan vertices where the layer has thickness; <= 0: they cross
        double off = 0;  // faces from the model's vertices
        double edge_off = 0;  // edges from the faces that meet there
    };

    PlanCells cells;
    std::vector<Corner> corners;       // [cells.corners]
    std::vector<Edge> edges;           // [cells.edges]
    std::vector<HeightPatch> patches;  // [cells.cells]
    std::vector<SideCurve> sides;      // [cells.sides]
    std::vector<BodyQuality> quality;  // [cells.bodies]
    double size = 0;                   // diagonal of the model's box
};

struct SmoothBrepOptions {
    double tolerance = 1e-4;              // of the size: how far faces may be from the model's vertices
    double thickness_tolerance = 0.1;     // the same as a share of the mean thickness of the bodies at a face
    double thin_tolerance = 0.3;          // the same as a share of the thickness at the place
    double rim_tolerance = 2e-5;          // of the size: how far curves may be from lines of the plan
    std::size_t most_functions = 14'000;  // a patch
    PlanCellsOptions cells;
};

//! Fit patches and edges to a layer model. Patches whose bodies turn out to cross are fitted more closely; what still
//! crosses is told by `quality`.
SmoothBrep build_smooth_brep(const LayerModel& model, const SmoothBrepOptions& options = {});

}  // namespace stratareeb
