// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "boreholes/point.h"

namespace stratareeb {

//! Median distance of a site from its nearest; 1 for fewer than two sites. Of many sites, a thousand are asked.
double median_gap(std::span<const Point2> at);

//! How far the sites stretch, whichever way they are turned: the diagonal of a square over which sites spread evenly would lie
//! as far from their middle, by root mean square.
double extent_of(std::span<const Point2> at);

}  // namespace stratareeb
