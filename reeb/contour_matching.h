// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reeb/sampled_contour.h"

namespace stratareeb {

//! Which places of two contours belong together.
enum class Matching {
    Automatic,  // by shape where that cuts to a quarter how much ways from contour to contour differ (mean of squares), else by length
    ByLength,   // see aligned_origin
    ByShape,    // see contour_warp
};

//! The second contour with parameters that fit the first one's. By shape, what is before and after a bay or a tongue that one of
//! them lacks still belongs together: places are paired in order around both (see contour_warp), then each corner goes
//! to the nearest place around its partner. Parameters by length have a share in it, the less the nearer the contours are, so
//! that no stretch gets lost over many contours.
//! \return the second contour, from the place that belongs to parameter 0 of the first
SampledContour matched_contour(const SampledContour& first, const SampledContour& second,
                               Matching matching = Matching::Automatic);

//! The same contours, each matched to the one before.
std::vector<SampledContour> matched_contours(std::vector<SampledContour> contours);

}  // namespace stratareeb
