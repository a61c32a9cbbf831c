// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/layer_model.h"
#include "subdivision/smoothness.h"

namespace stratareeb {

struct RefineLayersOptions {
    int levels = 2;  // each quadruples the triangles; 0 = the model as it is
    double fairness =
        0.1;  // weight of bending against closeness to the prediction; contacts are met whatever it is
    bool smooth_below = true;  // layers below one that ends take up the bend at its end
    //! Called between the steps with what is being done and its share (0..1), from one thread.
    std::function<void(const char* step, double share)> progress;
};

struct RefinedLayers {
    LayerModel model;
    SmoothnessReport smoothness;
};

//! A layer model's horizons as smooth surfaces: C. Loop's subdivision of x, y, the ground and each layer's thickness
//! over the one plan mesh, with vertices on the limit surface. It passes through all contacts of holes. Horizons stay in
//! order and solids watertight: thickness is 0 where it was 0 and positive where it was positive, since the
//! weights of subdivision are. Each layer ends in a crease along its pinch-out line; horizons below it stay smooth.
//! The plan keeps its outline and does not fold.
//! \throw InvalidInput for levels below 0 or beyond 6
RefinedLayers refine_layers(const LayerModel& control, const RefineLayersOptions& options = {});

}  // namespace stratareeb
