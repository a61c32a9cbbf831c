// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/hole_log.h"

namespace stratareeb {

//! Give the k-th occurrence (k ≥ 2) of a unit in a hole a unit of its own, called "code (k)". Logs are clean.
void split_repeats(LogSet& logs);

//! Renumber units from top to bottom: by `order` (codes) where it is not empty, otherwise inferred from the
//! holes, each voting by the mean depth at which it has a unit. Units that a given order lacks come after it.
//! Pairs of units that holes contradict are warned of, with the holes.
//! \return the number of units in the order.
std::size_t order_units(LogSet& logs, const std::vector<std::string>& order, Audit& audit);

//! Make units never decrease down each hole: keep the heaviest chain by thickness among the first `ordered`
//! units and give other intervals to the kept one above (below, if none is above), with a warning per
//! interval.
void fit_logs_to_order(LogSet& logs, std::size_t ordered, Audit& audit);

}  // namespace stratareeb
