// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"
#include "subdivision/crease_field.h"

namespace stratareeb {

//! Edges that a layer's thickness leans along: those of its triangles at vertices of its pinch-out line that do not have as many of them
//! as of others. Where they do, thickness shrinks from level to level as the plan around the vertex does: slopes settle, and
//! so do normals. Where they do not, the line has a kink in the plan, along which no slope but 0 keeps the thickness at 0. By Loop's rule
//! slopes would grow without end where the layer has more of the triangles; leaning, they fall by a quarter a level, as by that rule they do
//! in two triangles of six.
//! \param plan creases of the plan, at whose ends nothing leans
std::vector<LeaningEdge> leaning_edges(const LayerModel& model, std::size_t layer, const FieldCreases& plan);

}  // namespace stratareeb
