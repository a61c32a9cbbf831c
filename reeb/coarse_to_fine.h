// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/span_costs.h"

namespace stratareeb {

//! A cheap cycle between two closed contours of two points or more, seldom the cheapest: solved for contours with every two
//! points joined to their middle, and of these, and so on; then made better within a band of some rows, finer and finer.
//! Time and memory m + n.
SpanPath coarse_to_fine_cycle(const SpanContours& contours);

}  // namespace stratareeb
