// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/layer_model.h"

namespace stratareeb {

//! The same model with its plan's triangles numbered from neighbour to neighbour and its vertices as the triangles meet them, so
//! that differences between one number and the next are small. The corners of a triangle keep their turn; the half-edges of
//! the outline are numbered by triangle, then by corner.
//! \throw GeometryError if the plan is no 2-manifold
LayerModel in_view_order(const LayerModel& model);

//! What the surfaces would be without smoothing: straight between boreholes. The Delaunay triangulation of the holes that stand in
//! the footprint, with the elevations the model has there. Without triangles if the holes lie in a line or are fewer than three.
LayerModel straight_between_holes(const LayerModel& model);

}  // namespace stratareeb
