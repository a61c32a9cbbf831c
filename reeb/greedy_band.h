// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/span_costs.h"

namespace stratareeb {

//! The fast triangulation (H. Christiansen, T. Sederberg 1978): from a first span on, always take the shorter of the two
//! next spans (by parametric distance if that is the cost); on a tie the lower end moves. Time m + n. Open polylines start
//! with the span of their first points.
//! \return the path and its true cost; it winds once around closed contours.
SpanPath greedy_path(const SpanContours& contours, std::uint32_t first_upper, std::uint32_t first_lower);

//! The lower end of the shortest span from an upper point; the first of equals.
std::uint32_t nearest_lower_point(const SpanContours& contours, std::uint32_t upper);

}  // namespace stratareeb
