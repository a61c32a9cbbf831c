// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/cad_body.h"
#include "mesh/layer_solid.h"

namespace stratareeb {

//! The bodies of a layer as solids of planar faces: coplanar neighbouring triangles become one polygon.
//! \throw as planar_bodies, with the layer's name.
std::vector<CadBody> faceted_bodies(const LayerSolid& layer);

}  // namespace stratareeb
