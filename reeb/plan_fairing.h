// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Smooth a closed surface in plan: in each round, free vertices go half way to the middle of their neighbours and then a little farther
//! back, x and y only, so that bends go and sizes stay (G. Taubin 1995). Heights and connections stay, and with them the Reeb
//! graph over height; all other vertices stay where they are.
//! \param is_free by vertex
void fair_in_plan(TriangleSoup& soup, const std::vector<bool>& is_free, std::size_t rounds);

}  // namespace stratareeb
