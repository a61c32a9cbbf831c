// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace stratareeb {

//! The mean over a triangle of max(f - level, 0), f linear with these values at the corners: exact, and without cancellation
//! however small the part above the level is.
double mean_above(const std::array<double, 3>& corners, double level);

//! The mean over a triangle of the length of [base, top] ∩ [low, high], base <= top linear. 0 if low >= high.
double mean_thickness_between(const std::array<double, 3>& base, const std::array<double, 3>& top, double low,
                              double high);

}  // namespace stratareeb
