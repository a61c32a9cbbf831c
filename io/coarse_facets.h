// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "io/cad_body.h"
#include "mesh/layer_model.h"
#include "subdivision/plan_cells.h"

namespace stratareeb {

struct CoarseFacetsOptions {
    double max_error = 0;               // how far horizons may move up or down, in the model's unit
    std::size_t most_triangles = 6000;  // of the plan: reached in any case, at a larger error if need be
    double volume_tolerance = 2e-3;     // share by which a body's volume may differ
};

//! Bodies of a layer model as solids of planar faces, fewer than the model has: of the model with triangles left out, so
//! that these bodies share their triangles with each other. The error is quartered, twice at most, where volumes would differ;
//! what is missing then comes by a factor of the thickness.
struct CoarseFacets {
    std::vector<std::shared_ptr<const TopoDS_Shape>> solids;  // [bodies asked for]
    double deviation = 0;  // largest vertical distance of a horizon from the model's
};

//! \param bodies of `cells`, which are the model's
//! \throw GeometryError if a body falls apart
CoarseFacets coarse_facets(const LayerModel& model, const PlanCells& cells,
                           const std::vector<std::size_t>& bodies, const CoarseFacetsOptions& options);

}  // namespace stratareeb
