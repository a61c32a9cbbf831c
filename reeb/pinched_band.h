// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/span_costs.h"

namespace stratareeb {

//! Whether a cycle comes through a span twice: all upper edges follow one another, then all lower ones. The band is two cones
//! then, over the upper contour from a lower point and over the lower one from an upper point, which share a span: four
//! triangles on an edge, not a 2-manifold. Contours that lie side by side have such a band as their cheapest.
bool is_pinched(const SpanPath& cycle);

//! The cheapest cycle that differs from a pinched one by one step taken earlier or later: every span is an edge of two
//! triangles. Time m + n.
//! \pre Both contours have two points or more.
SpanPath opened(const SpanPath& pinched, const SpanContours& contours);

}  // namespace stratareeb
