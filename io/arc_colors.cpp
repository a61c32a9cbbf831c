// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/arc_colors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace stratareeb {

namespace {

constexpr std::array<Rgb, 9> kPalette{{{51, 34, 136},
                                       {204, 102, 119},
                                       {68, 170, 153},
                                       {153, 153, 51},
                                       {136, 204, 238},
                                       {136, 34, 85},
                                       {221, 204, 119},
                                       {17, 119, 51},
                                       {170, 68, 153}}};
constexpr std::size_t kColors = 3 * kPalette.size();
constexpr std::uint32_t kPure = (1u << kPalette.size()) - 1, kAll = (1u << kColors) - 1;

Rgb mixed(const Rgb& color, double with, double share) {
    Rgb result{};
    for (int k = 0; k < 3; ++k)
        result[k] = static_cast<std::uint8_t>(std::lround(color[k] + share * (with - color[k])));
    return result;
}

//! The least used of the colours in a set, the first of equals.
std::size_t least_used(std::uint32_t set, const std::array<std::size_t, kColors>& uses) {
    std::size_t best = static_cast<std::size_t>(std::countr_zero(set));
    for (std::size_t i = best; i < kColors; ++i)
        if ((set >> i & 1) && uses[i] < uses[best]) best = i;
    return best;
}

}  // namespace

Rgb palette_color(std::size_t i) {
    const Rgb& color = kPalette[i % kPalette.size()];
    const std::size_t shade = i / kPalette.size() % 3;
    return shade == 0 ? color : shade == 1 ? mixed(color, 255, 0.45) : mixed(color, 0, 0.4);
}

std::vector<Rgb> arc_colors(const ReebGraph& graph) {
    std::vector<std::uint32_t> taken(graph.nodes.size(), 0);  // colours at each node, one bit each
    std::array<std::size_t, kColors> uses{};
    std::vector<Rgb> colors;
    for (const ReebArc& arc : graph.arcs) {
        std::uint32_t free = kAll & ~(taken[arc.lower] | taken[arc.upper]);
        if (free & kPure) free &= kPure;
        const std::size_t color = least_used(free ? free : kAll, uses);
        ++uses[color];
        taken[arc.lower] |= 1u << color;
        taken[arc.upper] |= 1u << color;
        colors.push_back(palette_color(color));
    }
    return colors;
}

Rgb node_color(CriticalType type) {
    return type == CriticalType::Minimum  ? Rgb{0, 114, 178}
           : type == CriticalType::Saddle ? Rgb{240, 200, 40}
                                          : Rgb{213, 94, 0};
}

}  // namespace stratareeb
