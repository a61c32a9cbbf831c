// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graded_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stratareeb {

namespace {

constexpr double kTooClose = 0.4;  // of the graded spacing there, to a level that is there anyway

//! Rises above a graded end: up to a spacing, but not beyond the edge's middle.
std::vector<double> rises(double spacing, double most, std::size_t steps) {
    std::vector<double> result;
    for (std::size_t j = 1; j < steps; ++j) {
        const double share = static_cast<double>(j) / static_cast<double>(steps);
        if (share * share * spacing < most) result.push_back(share * share * spacing);
    }
    return result;
}

}  // namespace

std::vector<double> graded_levels(std::span<const double> levels, double low, double high, GradedEnds ends) {
    const auto first = std::ranges::upper_bound(levels, low), last = std::ranges::lower_bound(levels, high);
    std::vector<double> result;
    if (first >= last) return result;
    result.assign(first, last);
    if (levels.size() < 2) return result;
    const double spacing = levels[1] - levels[0];
    const auto steps = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(levels.size()))));
    const std::vector<double> even = result;
    for (const bool at_low : {true, false}) {
        if (!(at_low ? ends.low : ends.high)) continue;
        for (const double rise : rises(spacing, (high - low) / 2, steps)) {
            const double z = at_low ? low + rise : high - rise;
            const double own = 2 * std::sqrt(rise * spacing) / static_cast<double>(steps);
            const auto near = [&](double level) { return std::abs(level - z) < kTooClose * own; };
            if (low < z && z < high && std::ranges::none_of(even, near)) result.push_back(z);
        }
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

}  // namespace stratareeb
