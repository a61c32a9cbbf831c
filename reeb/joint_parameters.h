// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reeb/sampled_contour.h"

namespace stratareeb {

//! Parameters at which to sample what is between two contours, near the first: all of its own, and those of points of the other one without
//! which that would be farther off than a 50th of the chord in their place: corners, and bends of more than some 9 degrees. So
//! no corner is cut half way, and none comes so close to another that it makes a sliver.
//! \return ascending, in [0, 1)
std::vector<double> joint_parameters(const SampledContour& own, const SampledContour& other);

}  // namespace stratareeb
