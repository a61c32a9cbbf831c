// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/height_patch.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

struct HorizonSheetsOptions {
    double tolerance = 1e-4;           // of the size: how far sheets may be from the model's vertices
    double thickness_tolerance = 0.1;  // the same as a share of the mean thickness of the body
    double thin_tolerance = 0.3;       // the same as a share of the thickness at the place
    double end_gap =
        0;  // of the size: how far a base stays below the sheet that it ends at; 0 = they meet and may cross
    double thin_end_gap =
        5e-4;  // the same as a share of the mean thickness of the body: its volume counts it in
    std::size_t most_functions = 9'000;  // a sheet
    std::vector<double> volume_factors;  // [body] of the model's volume, that sheets are fitted to; empty = 1
    std::function<void(double share)> progress = {};  // 0..1 of the sheets, from one thread at a time
};

//! The heights of a layer model as few smooth sheets: one for the ground, one for the base of each body. Where a body
//! ends, its base meets the sheet above it, which goes on. A cell (a face between two bodies) is a part of the sheet of the
//! body above it, so that faces of one sheet that meet in an edge meet exactly and without a kink.
struct HorizonSheets {
    std::vector<HeightPatch> sheets;     // [0] the ground, [1 + body] the base of a body
    std::vector<std::uint32_t> of_cell;  // [cells.cells]
    std::vector<double> mean_thickness;  // [body] of the model
    std::vector<double> gaps;            // [body] how far its base stays below the sheet that it ends at
    std::vector<double> off;             // [sheet] largest distance from the model's vertices
    std::vector<double> usual_off;       // [sheet] the same for all but a thousandth of the plan area
    std::vector<double>
        least_thickness;  // [body] at vertices and centres of triangles where it has some; <= 0: crosses
};

//! \param size of the model, which tolerances refer to
HorizonSheets fit_horizon_sheets(const LayerModel& model, const PlanCells& cells, const PlanCurves& curves,
                                 double size, const HorizonSheetsOptions& options = {});

//! Of a sheet over a triangle of the plan: its mean at the centres of nine equal parts.
double mean_height(const TriMesh& plan, std::uint32_t face, const HeightPatch& sheet);

}  // namespace stratareeb
