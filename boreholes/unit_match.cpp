// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/unit_match.h"

#include <algorithm>
#include <limits>

namespace stratareeb {

namespace {

constexpr double kBottomless = std::numeric_limits<double>::infinity();

//! Add the lengths of one unit's stretch from depth `from` to `to` to its row.
void add_stretch(std::vector<double>& row, const std::vector<double>& predicted, double from, double to) {
    double top = 0;
    for (std::size_t j = 0; j <= predicted.size(); ++j) {
        const double base = j < predicted.size() ? top + predicted[j] : kBottomless;
        row[j] += std::max(0.0, std::min(to, base) - std::max(from, top));
        top = base;
    }
}

}  // namespace

double UnitMatch::drilled(std::size_t unit) const {
    double sum = 0;
    for (const double part : length[unit]) sum += part;
    return sum;
}

double UnitMatch::share_right() const {
    double all = 0, good = 0;
    for (std::size_t unit = 0; unit < length.size(); ++unit) {
        all += drilled(unit);
        good += right(unit);
    }
    return all > 0 ? good / all : 0;
}

UnitMatch match_units(const Survey& survey, std::span<const HeldOutHole> held) {
    const std::size_t units = survey.units.size();
    UnitMatch match{std::vector(units, std::vector<double>(units + 1, 0.0))};
    for (const HeldOutHole& hole : held) {
        double depth = 0;
        const auto& layers = survey.holes[hole.hole].layers;
        for (std::size_t i = 0; i < layers.size() && layers[i].knowledge != Knowledge::Unknown; ++i) {
            add_stretch(match.length[i], hole.thickness, depth, depth + layers[i].thickness);
            depth += layers[i].thickness;
            if (layers[i].knowledge == Knowledge::AtLeast) break;
        }
    }
    return match;
}

}  // namespace stratareeb
