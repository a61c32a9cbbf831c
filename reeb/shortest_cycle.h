// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reeb/span_costs.h"

namespace stratareeb {

//! How much there was to do, for those who measure it.
struct ShortestCycleWork {
    std::size_t spans = 0;   // looked at, once for each sweep over them
    std::size_t starts = 0;  // that had to be compared one by one
};

struct ShortestCycleOptions {
    bool corridor =
        true;  // first leave out what can't be part of the cheapest; false: compare all starts over all spans
    ShortestCycleWork* work = nullptr;
};

//! The cheapest of all triangulations between two closed contours: the shortest of the cycles in the toroidal graph that wind
//! once around both contours, over all first spans (H. Fuchs, Z. Kedem, S. Uselton 1977). Costs of equal cycles decide by their
//! last bit; of costs equal to that, the choice is the same in each run.
//!
//! Shortest paths don't cross, so one of them bounds those from the starts on both sides: divide and conquer, O(m n log m) for
//! the shorter contour's m points. Before, spans are left out that no cycle uses which is as cheap as a good known one.
//! Memory: two bytes and a bit per span of the graph at most, in practice a small part of that.
//! \pre Both contours have two points or more.
SpanPath shortest_cycle(const SpanContours& contours, const ShortestCycleOptions& options = {});

}  // namespace stratareeb
