// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/layer_model.h"

namespace stratareeb {

//! The same surfaces with a vertex in the middle of each edge that joins two holes, so that what one hole asks of a smooth
//! surface never stands against what its neighbour asks.
LayerModel separated_holes(LayerModel model);

}  // namespace stratareeb
