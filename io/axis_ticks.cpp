// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {

double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

double round_exaggeration(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5})
        if (factor * power <= most) return factor * power;
    return power;
}

std::vector<double> ticks(double low, double high, double about) {
    if (!(high > low)) return {low};
    const double step = round_step((high - low) / about);
    std::vector<double> result;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
        result.push_back(k * step + 0.0);  // no -0
    return result;
}

std::string tick_text(double value, double step) {
    const double largest = std::max(std::abs(value), step);
    if (largest >= 1e7 || step < 1e-6) return fmt::format("{:g}", value);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace stratareeb
