// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! What a vertex of a closed surface is to its height: kLowest or kHighest if no neighbour is lower, or higher; else how often the neighbours around
//! it change between lower and higher: 2 on a slope, 4 at a saddle, 6 at a threefold one. Equal heights count by vertex number.
constexpr int kLowest = -1, kHighest = 0;

//! By vertex; for those that are asked for.
std::vector<int> link_signs(const TriangleSoup& soup, const std::vector<bool>& is_asked);

}  // namespace stratareeb
