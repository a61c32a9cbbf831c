// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reeb/sampled_contour.h"

namespace stratareeb {

//! Which places of one contour belong to which of another.
struct ContourWarp {
    bool is_centred = false;  // found with both contours' centres on one another
    double start = 0;         // on the second contour
    std::vector<double>
        partners;  // on the first, of even places on the second from there: not falling, once around

    //! The place on the first contour, counted on around it, for one on the second.
    double partner(double s) const;
};

//! Dynamic time warping in plan between even places of two contours with parameters by length: a way around both of them in order, on which
//! places are near each other and the contours run the same way; found once where contours are and once from their centres, which is taken
//! if it is much better. The way closes at a pair of places that a first way around went through half way.
//! Time and memory in proportion to the square of count.
//! \param count places on each
ContourWarp contour_warp(const SampledContour& first, const SampledContour& second, std::size_t count);

}  // namespace stratareeb
