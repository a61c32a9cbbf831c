// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "boreholes/point.h"
#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"
#include "subdivision/spline_fit.h"

namespace stratareeb {

//! The bodies of a layer model as few smooth faces: a bicubic B-spline sheet for the ground and for the base of
//! each body, trimmed by cubic B-spline edges, and upright walls. Each curve in plan is its own curve in a sheet's parameters, so that faces
//! and edges differ in height only, by no more than the tolerances here say.
struct SmoothBrep {
    static constexpr std::size_t kMostCadSpans = 96;  // long edges make files quick to open

    //! x, y, z over a parameter; a line between its corners where it is upright.
    struct Edge {
        SplineCurve curve{CubicKnots({0, 1}), {}};
        std::vector<double> tolerances;  // [span] sheets and curve are no further apart
        double side_start = 0;  // on the rim: its beginning on its side, whose parameter goes on from there
        std::size_t cad_spans = kMostCadSpans;  // of one of the edges that CAD programs get for it
    };

    struct BodyQuality {
        double mesh_volume = 0;  // of the model's triangles
        double volume = 0;       // between its faces
        double least_thickness =
            0;           // top above base, at plan vertices where the layer has thickness; <= 0: they cross
        double off = 0;  // faces from the model's vertices
        double usual_off = 0;  // the same for all but a thousandth of the plan area
        double edge_off = 0;   // edges from the faces that meet there
    };

    PlanCells cells;
    std::vector<Point3> corners;  // [cells.corners]
    std::vector<Edge> edges;      // [cells.edges]
    HorizonSheets horizons;
    std::vector<double> cuts;          // x of lines along which faces were cut
    std::vector<SideCurve> sides;      // [cells.sides]
    std::vector<BodyQuality> quality;  // [cells.bodies]
    double size = 0;                   // diagonal of the model's box

    const HeightPatch& sheet(std::uint32_t cell) const { return horizons.sheets[horizons.of_cell[cell]]; }
};

struct SmoothBrepOptions {
    HorizonSheetsOptions sheets;
    double rim_tolerance = 2e-5;  // of the size: how far curves may be from lines of the plan
    bool snap_lines = true;       // move lines where bodies end to where their sheets meet
    PlanCellsOptions cells;
};

//! Fit sheets and edges to a layer model. Bodies that cross all the same are told by `quality`.
SmoothBrep build_smooth_brep(const LayerModel& model, const SmoothBrepOptions& options = {});

//! The same from sheets that were fitted before, for other options of lines.
SmoothBrep rebuild_smooth_brep(const LayerModel& model, const HorizonSheets& sheets,
                               const SmoothBrepOptions& options);

//! CAD programs integrate along an edge with a fixed number of points: one of many spans may be made of several edges.
//! \return the spans that they begin with, and the number of spans
std::vector<std::size_t> cad_edge_ends(const SmoothBrep::Edge& edge);

//! How far edges are from the sheets that meet there, for `tolerances` and `quality`.
void measure_edges(SmoothBrep& brep);

}  // namespace stratareeb
