// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/stacked_column.h"

#include <algorithm>

namespace stratareeb {

namespace {

constexpr double kKept = 0.1;  // of its thickness, by a unit from which thickness is taken

}  // namespace

std::vector<double> uncut_bases(const UncutColumn& column, std::span<const LayerSequence> sequences) {
    std::vector<double> base(column.thickness.size(), 0.0);
    for (std::size_t n = sequences.size(); n-- > 0;) {
        const LayerSequence& s = sequences[n];
        if (!s.anchored) continue;
        base[s.last] = column.anchor[n];
        if (s.on_onlap) {
            const double relief = base[s.last + 1];
            base[s.last] = relief + column.taper[s.last + 1] * std::max(0.0, column.anchor[n] - relief);
        }
        if (s.stands)
            for (std::size_t i = s.last; i > s.first; --i) base[i - 1] = base[i] + column.thickness[i];
    }
    return base;
}

PlacedUnit place_unit(const UncutColumn& column, std::span<const double> bases, const LayerSequence& s,
                      std::size_t unit, double top) {
    const double thickness = column.thickness[unit], taper = column.taper[unit];
    if (!s.stands && !(s.anchored && unit == s.last)) return {thickness, 1};
    const double clearance = top - bases[unit];
    if (taper <= 0) return {0, clearance};
    if (!s.stands) return {taper * std::max(0.0, clearance), clearance};
    if (s.onlaps && unit == s.first) return {std::max(0.0, clearance), clearance};
    const double filled = std::max(0.0, clearance - thickness);
    return {std::clamp(clearance, 0.0, thickness) + taper * filled, clearance};
}

std::vector<double> stacked_thicknesses(const UncutColumn& column, std::span<const LayerSequence> sequences) {
    const std::vector<double> bases = uncut_bases(column, sequences);
    std::vector<double> thickness;
    double top = column.ground;
    for (const LayerSequence& s : sequences)
        for (std::size_t i = s.first; i <= s.last; ++i) {
            thickness.push_back(place_unit(column, bases, s, i, top).thickness);
            top -= thickness.back();
        }
    return thickness;
}

void apply_minimum(std::vector<double>& thickness, const LayerRules& rules) {
    double pushed = 0;  // how far the horizon above lies below where it was
    for (std::size_t i = 0; i < thickness.size(); ++i) {
        if (thickness[i] <= 0) continue;
        const double before = thickness[i];
        const double least = std::max({rules.minimum(i), std::min(kKept * before, before)});
        thickness[i] = std::max(before - pushed, least);
        pushed += thickness[i] - before;
    }
}

}  // namespace stratareeb
