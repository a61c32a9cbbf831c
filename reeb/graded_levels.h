// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace stratareeb {

//! The end of an edge of a graph at which contours spread, or shrink, like the root of the height: a minimum, maximum or saddle.
struct GradedEnds {
    bool low = false, high = false;
};

//! Those of the levels that are strictly between two heights, and further ones on the first spacing beside graded ends, at the squares of even steps,
//! so that contours move by about the same way from one to the next. The steps are as many as the root of the number of levels: what
//! is between the node and the first level then shrinks with the square of the spacing. None where no level is between.
//! \pre levels ascend
std::vector<double> graded_levels(std::span<const double> levels, double low, double high, GradedEnds ends);

}  // namespace stratareeb
