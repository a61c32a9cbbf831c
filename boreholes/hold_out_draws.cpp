// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hold_out_draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "boreholes/permutation.h"

namespace stratareeb {

std::vector<Draw> fold_draws(std::size_t holes, std::size_t folds, std::uint64_t seed) {
    if (folds < 2 || folds > holes)
        throw InvalidInput(fmt::format(
            "{} folds of {} holes: give at least 2 and at most as many as there are holes", folds, holes));
    const auto order = random_permutation(holes, seed);
    std::vector<Draw> draws(folds);
    for (std::size_t h = 0; h < holes; ++h) draws[order[h] % folds].push_back(h);
    return draws;
}

std::vector<Draw> repeated_draws(std::size_t holes, std::size_t at_a_time, double share, std::uint64_t seed) {
    if (at_a_time < 1 || at_a_time >= holes)
        throw InvalidInput(fmt::format(
            "{} of {} holes left out at a time: give at least 1 and leave at least 1", at_a_time, holes));
    if (!(share > 0 && share <= 1))
        throw InvalidInput(fmt::format("a share of {} of the holes: give more than 0 and at most 1", share));
    // A share such as 0.3 of 10 is 3 holes, whatever its last binary digit.
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(holes) * (1 - 1e-12)));
    const auto order = random_permutation(holes, seed);
    std::vector<Draw> draws;
    for (std::size_t begin = 0; begin < wanted; begin += at_a_time) {
        const std::size_t end = std::min(begin + at_a_time, holes);
        Draw& draw = draws.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(begin),
                                        order.begin() + static_cast<std::ptrdiff_t>(end));
        std::ranges::sort(draw);
    }
    return draws;
}

std::vector<Draw> single_draws(std::size_t holes) {
    std::vector<Draw> draws;
    for (std::size_t h = 0; h < holes; ++h) draws.push_back({h});
    return draws;
}

}  // namespace stratareeb
