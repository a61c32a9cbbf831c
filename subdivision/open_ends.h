// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/layer_model.h"
#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_cells.h"
#include "subdivision/plan_curves.h"

namespace stratareeb {

//! Bend bases, by as little as does, until no body is closed beside the curves where it ends: along these its base lies half
//! its gap below the sheet above or lower, inside it is nowhere nearer to it, and the body opens inwards. Where sheets cross
//! inside a body, CAD programs find a new edge beside the one that ends it; where its base leans the wrong way there,
//! OpenCASCADE takes it for a face inside the neighbour (BOPTools_AlgoTools::GetFaceOff compares directions a few
//! tolerances away from an edge). Thicknesses are measured anew.
void open_body_ends(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                    const PlanCurves& curves);

}  // namespace stratareeb
