// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
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

//! A vertex as a mean of others: of two along an edge, of three in a triangle.
struct VertexMean {
    std::uint32_t vertex = 0;
    std::vector<std::pair<std::uint32_t, double>> of;
};

struct LayerRegionsOptions {
    //! Where a body would touch itself at a hole that lacks the layer, the layer is left out around the hole
    //! up to this share of the way to the next vertices, and is itself again at twice that share.
    double opening = 0.25;
    //! Called for each vertex that mend_layer_regions adds, in order.
    std::function<void(const VertexMean&)> on_vertex = {};
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

//! The same cuts where regions are known: zero_at and in_face are given, and grow with the mesh. A vertex added within a
//! layer's region has thickness there.
void mend_layer_regions(PlanMesh& plan, LayerRegions& regions, std::size_t layers,
                        const LayerRegionsOptions& options = {});

}  // namespace stratareeb
