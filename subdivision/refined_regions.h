// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/layer_regions.h"
#include "subdivision/loop_topology.h"

namespace stratareeb {

//! Layers' regions on the finest level: triangles take over the layers of the one they are part of, and a layer has
//! no thickness where a triangle around lacks it, nor along the rim between two vertices that lack it.
LayerRegions refined_regions(const LayerRegions& control, const LoopTopology& topology);

}  // namespace stratareeb
