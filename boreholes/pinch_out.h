// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace stratareeb {

//! Where a layer ends between a hole that lacks it and one that has it: the share of the way from the former
//! to the latter, 0 <= fraction < 1. Along every edge of the holes' triangulation the layer is absent up to
//! that point.
struct PinchOutRule {
    double fraction = 0.5;
};

//! "at-hole" (0), "quarter", "third" or "half".
//! \throw InvalidInput for any other name.
PinchOutRule pinch_out_rule(std::string_view name);

}  // namespace stratareeb
