// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/clamped_mean.h"

#include <algorithm>
#include <cstddef>

namespace stratareeb {

double mean_above(const std::array<double, 3>& corners, double level) {
    std::array<double, 3> f{corners[0] - level, corners[1] - level, corners[2] - level};
    std::ranges::sort(f);
    const auto [a, b, c] = f;
    if (!(c > 0)) return 0;
    if (a >= 0) return (a + b + c) / 3;
    // A tip with corner c, similar to the triangle by c / (c - a) and c / (c - b) along its sides.
    if (b <= 0) return c / 3 * (c / (c - a)) * (c / (c - b));
    // The triangle without the tip below: ((b + c + a) (b - a) (c - a) - a³) / 3 (b - a) (c - a), all terms made positive.
    const double below = -a, sum = b + c, product = b * c;
    return (below * (sum * sum - product) + sum * product) / (3 * (below + b) * (below + c));
}

double mean_thickness_between(const std::array<double, 3>& base, const std::array<double, 3>& top, double low,
                              double high) {
    if (!(low < high)) return 0;
    const auto [lowest_base, highest_base] = std::ranges::minmax(base);
    const auto [lowest_top, highest_top] = std::ranges::minmax(top);
    if (highest_top <= low || lowest_base >= high) return 0;
    double mean = 0;
    // What lies inside altogether isn't made a difference of larger numbers.
    const bool above_low = lowest_base >= low, below_high = highest_top <= high;
    for (std::size_t i = 0; i < 3 && above_low && below_high; ++i) mean += (top[i] - base[i]) / 3;
    if (above_low && below_high) return mean;
    mean = mean_above(top, low) - mean_above(base, low) - mean_above(top, high) + mean_above(base, high);
    return std::max(0.0, mean);
}

}  // namespace stratareeb
