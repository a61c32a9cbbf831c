// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

//! Is this ground, with one height for each place? Its contours are level and, along each edge, lie in one another without touching: upper
//! ones inside lower ones, around a hole the other way round; and no hole closes above. One in twenty may be otherwise. The
//! underside that closes a body does not count.
bool is_terrain(const EnhancedReebGraph& graph);

}  // namespace stratareeb
