// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "subdivision/height_patch.h"
#include "subdivision/spline_fit.h"

namespace stratareeb {

//! How far a curve of x, y, z is from a sheet within one of its spans, upright, at samples.
double distance_within_span(const SplineCurve& curve, std::size_t span, const HeightPatch& sheet);

}  // namespace stratareeb
