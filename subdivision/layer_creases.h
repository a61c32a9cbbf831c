// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/crease_field.h"

namespace stratareeb {

//! Where the fields over a layer model's plan are not smooth; numbers are those of the plan mesh.
struct LayerCreases {
    FieldCreases plan;                    // of x, y, the ground, and part of all others
    std::vector<FieldCreases> thickness;  // of each layer: its pinch-out line too
};

//! Of x, y and the ground: corners of the outline are sharp; where it turns inwards, an inner edge is a crease,
//! since a smooth patch would fold there.
FieldCreases plan_creases(const LayerModel& model);

//! Thickness has a crease along the edges between triangles with the layer and without, and a corner where it
//! would not stay 0 otherwise; around vertices where that line has a kink its edges lean towards 0.
LayerCreases layer_creases(const LayerModel& model, FieldCreases plan);

//! A layer that ends bends every horizon below along its pinch-out line. The first layer below that is there on
//! both sides takes the bend up between its top and its base, so that horizons further down stay smooth.
struct Handover {
    static constexpr std::size_t kNobody = ~std::size_t{0};

    std::uint32_t edge = 0;  // of the ending layer's pinch-out line
    std::size_t to =
        kNobody;  // the layer that takes up the bend; kNobody where all below end around there too
};

//! The handovers along one layer's pinch-out line, by edge.
std::vector<Handover> handovers(const LayerModel& model, std::size_t layer);

//! A layer's creases without those edges of its pinch-out line, and without corners that stood on them alone and edges that
//! leaned at their ends.
FieldCreases without_edges(const LayerModel& model, const LayerCreases& creases, std::size_t layer,
                           const std::vector<std::uint32_t>& edges);

}  // namespace stratareeb
