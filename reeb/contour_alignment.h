// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reeb/sampled_contour.h"

namespace stratareeb {

//! The parameter of the second contour that belongs to parameter 0 of the first: with it as origin, points of equal parameters are closest to
//! each other, in the mean of squares over the whole contours, each seen from its own centre. Where the closest pair of
//! the thesis (correspond) looks at one place, this looks at all; contours with noise or corners come out untwisted. Time in proportion to
//! the contours' points.
double aligned_origin(const SampledContour& first, const SampledContour& second);

//! The same contours, each turned to fit the one before.
std::vector<SampledContour> aligned_contours(std::vector<SampledContour> contours);

}  // namespace stratareeb
