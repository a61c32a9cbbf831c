// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/unit_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stratareeb {
namespace {

// Hues of the qualitative set of Okabe and Ito (2008), which the common kinds of colour blindness tell apart,
// ordered so that light and dark alternate down the column.
constexpr std::array<std::array<int, 3>, 8> kHues{{{240, 228, 66},
                                                   {0, 114, 178},
                                                   {230, 159, 0},
                                                   {0, 158, 115},
                                                   {86, 180, 233},
                                                   {213, 94, 0},
                                                   {190, 190, 190},
                                                   {204, 121, 167}}};

// Each further round of the eight is mixed with white or black, a little more every second round.
int shaded(int channel, std::size_t round) {
    if (round == 0) return channel;
    const double strength = 0.5 * (1.0 - std::pow(0.85, static_cast<double>((round + 1) / 2)) * 0.7);
    const double target = round % 2 == 1 ? 255.0 : 0.0;
    return std::clamp(static_cast<int>(std::lround(channel + strength * (target - channel))), 0, 255);
}

}  // namespace

std::string unit_color(std::size_t order) {
    const auto& hue = kHues[order % kHues.size()];
    const std::size_t round = order / kHues.size();
    return fmt::format("#{:02x}{:02x}{:02x}", shaded(hue[0], round), shaded(hue[1], round),
                       shaded(hue[2], round));
}

void color_units(std::vector<Unit>& units) {
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].color.empty()) units[i].color = unit_color(i);
}

}  // namespace stratareeb
