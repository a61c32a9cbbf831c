// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "mesh/layer_model.h"

namespace stratareeb {

struct DecimateLayersOptions {
    std::optional<std::size_t> triangles;  // of the plan: stop there
    //! How far, vertically, any horizon may end from where it was, in the model's unit; 0 = only what is flat goes.
    std::optional<double> max_error;
    //! How far pinch-out lines may be straightened, in plan; empty = a tenth of the model's spacing; 0 = not at all.
    std::optional<double> line_tolerance;
    double min_angle_deg = 10;  // in plan; triangles flatter than that are made only where there were some
    std::function<void(double share)> progress;  // 0..1, from one thread
};

struct DecimatedLayers {
    LayerModel model;
    std::size_t triangles_before = 0;  // of the plan
    double deviation = 0;  // largest vertical distance of any horizon, anywhere, from where it was: measured
    bool target_reached = true;
    std::string note;  // for people: how many triangles are left, how far it is off, why not fewer
};

//! Fewer triangles for the same layers. Vertices of the plan are taken out one by one (half-edge collapses), the one whose
//! removal moves the horizons least first; no vertex moves. So all horizons keep sharing one triangulation, solids stay
//! watertight and conform, and horizons stay in order. Kept as they are: holes' vertices and their contacts, the outline
//! (vertices go only from its straight parts), where pinch-out lines meet each other or the outline, the layers' regions
//! on both sides of these lines, and thickness 0 where it is 0. Deterministic.
//! \throw InvalidInput if neither a number of triangles nor an error is given, or one is negative
DecimatedLayers decimate_layers(const LayerModel& model, const DecimateLayersOptions& options);

}  // namespace stratareeb
