// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/fault_blocks.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! Where no fault is between two blocks.
struct BlocksInOne {
    std::vector<WayOn> ways_on;
    double tolerance = 0;
};

//! Layer models of blocks as one model. Along common borders of the outlines both sides get the same plan vertices, and one
//! more wherever a horizon of one side crosses a horizon of the other: no two horizons cross between neighbouring vertices,
//! so that walls can be made of triangles which both sides share. Along ways on both sides get the mean of their elevations and
//! become one piece, but for places where a layer that one side has is absent on the other: there a step stays.
//! `outline` are the models' footprints relative to their common origin, `holes[b][i]` is the survey's number of the i-th hole
//! of block b.
//! \throw GeometryError if rounding defeats that.
LayerModel join_blocks(std::vector<LayerModel> blocks, const std::vector<Footprint>& outline,
                       const std::vector<std::vector<std::uint32_t>>& holes, const BlocksInOne& one = {});

}  // namespace stratareeb
