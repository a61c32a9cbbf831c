// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/crease_field.h"
#include "subdivision/loop_topology.h"

namespace stratareeb {

//! Smooth x and y over a plan mesh.
struct PlanLimit {
    std::vector<double> x, y;              // control values
    std::vector<double> limit_x, limit_y;  // at the finest level, on the limit surface
    FieldCreases creases;                  // of x, y, and of every field that is to look smooth over them
    std::size_t straightened = 0;  // triangles of the plan mesh that stay as they are, since they would fold
};

//! Control values of x and y whose limit has every hole at its place and all other vertices close to theirs, keeps
//! corners and straight sides of the outline, and does not fold: the triangles of the finest level are left turns (exact
//! predicates). Where they would fold the plan is made fairer, then truer to the given places, and where neither helps it stays linear.
PlanLimit plan_limit(const LayerModel& model, const LoopTopology& topology);

}  // namespace stratareeb
