// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/hold_out_draws.h"
#include "boreholes/point.h"

namespace stratareeb {

struct MatchedDraws {
    std::vector<Draw> draws;
    std::vector<std::size_t> group;  // by hole; holes that stand alone have one each
};

//! Draws in which left-out holes are about as far from the rest as places that are to be predicted are from the holes. Where holes
//! stand in groups, a hole alone is predicted by its neighbours, far places are not; so groups are left out together, of the size at
//! which the distances fit best (J. Linnenbrink, C. Milà, M. Ludwig and H. Meyer, "kNNDM CV", 2024; groups here are those of the
//! farthest-point centres, T. F. Gonzalez, 1985). Evenly spread holes are left out as fold_draws does.
//! \param asked distances of the places that are to be predicted from their nearest hole
//! \throw as fold_draws
MatchedDraws matched_draws(std::span<const Point2> holes, std::vector<double> asked, std::size_t folds,
                           std::uint64_t seed);

}  // namespace stratareeb
