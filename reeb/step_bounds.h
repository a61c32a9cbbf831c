// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reeb/span_costs.h"

namespace stratareeb {

//! What the steps of one end cost at least, whatever the other end does, summed up along the unrolled contours: entry i is the
//! bound of all steps from row (column) 0 to i.
struct StepBounds {
    std::vector<double> upper, lower;
};

//! Bounds for closed contours from the point of the other contour that is nearest to an edge's line (area) or to its end
//! (span length); 0 for parametric distances, which good paths come close to. Rows and columns are those of SpanCosts with
//! the same first points. `hint`, a cycle, says which points may be near one another.
StepBounds step_bounds(const SpanContours& contours, std::uint32_t first_upper, std::uint32_t first_lower,
                       const SpanPath& hint);

}  // namespace stratareeb
