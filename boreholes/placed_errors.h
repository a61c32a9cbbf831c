// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/error_by_gap.h"
#include "boreholes/hold_out.h"

namespace stratareeb {

//! Places of all holes that know a quantity, held out or not, and the draws they are in.
struct KnowingHoles {
    std::vector<Point2> at;
    std::vector<std::size_t> draw, number_of_hole;
};

KnowingHoles knowing_holes(const Survey& survey, const std::vector<Draw>& draws,
                           const std::function<bool(const Borehole&)>& knows);

bool knows_thickness(const Borehole& hole, std::size_t layer);
bool knows_horizon(const Borehole& hole, std::size_t k);

//! Residuals of held-out holes, each with its place and the distance to the nearest hole that its draw left in.
std::vector<PlacedError> placed_errors(const Survey& survey, const std::vector<Residual>& residuals,
                                       const KnowingHoles& know);

}  // namespace stratareeb
