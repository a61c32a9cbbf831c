// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <vector>

#include "boreholes/thickness_field.h"
#include "mesh/plan_mesh.h"

namespace stratareeb {

constexpr std::size_t kMaxLayers = 256;
using LayerSet = std::bitset<kMaxLayers>;

//! Where in plan each layer is. A layer has thickness at a vertex exactly when all triangles around the
//! vertex have the layer and the vertex does not stand on a line of no thickness.
struct LayerRegions {
    std::vector<LayerSet> in_face;  // layers present in each triangle
    std::vector<LayerSet> zero_at;  // layers without thickness at each vertex
    std::size_t opened = 0;         // vertices around which a layer was opened
};

struct LayerRegionsOptions {
    //! Where a body would touch itself at a hole that lacks the layer, the layer is left out around the hole
    //! up to this share of the way to the next vertices, and is itself again at twice that share.
    double opening = 0.25;
};

//! Read each layer's region off the plan mesh, whose edges hold the pinch-out lines, and cut triangles where
//! a layer's body would not be a 2-manifold or would have no thickness in a triangle that has it:
//!  - an edge across a present part whose two ends lie on pinch-out lines gets a vertex in its middle;
//!  - a triangle with all corners on pinch-out lines gets a vertex in its centre;
//!  - a vertex at which top and base would touch between two parts of the body is opened, see
//!  LayerRegionsOptions.
//! \throw InvalidInput beyond kMaxLayers; GeometryError if that does not come to an end.
LayerRegions build_layer_regions(PlanMesh& plan, const ThicknessField& field,
                                 const LayerRegionsOptions& options = {});

}  // namespace stratareeb
