// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reeb/span_costs.h"
#include "reeb/step_bounds.h"

namespace stratareeb {

//! A price per start (row of column 0): paid on starting there, paid back on ending one turn above. A closed path pays
//! nothing in the end, so any prices are right; good ones leave an open path no gain from ending elsewhere than it should.
struct StartPrices {
    std::vector<double> price;  // per start; at that of the known cycle: its bounds.upper
    double deviation = 0;       // no price is farther from bounds.upper than this
};

//! Prices by what a path has to pay from starts near that of a known cycle to come to it, and from it to come to the ends
//! near its end: half the difference.
//! \pre `cycle` starts at row rows() / 4, column 0 of the unrolled graph.
//! \param deviation how far prices may be from bounds.upper.
StartPrices start_prices(const SpanCosts& costs, const StepBounds& bounds, const SpanPath& cycle,
                         double deviation);

}  // namespace stratareeb
