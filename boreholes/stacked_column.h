// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/layer_rules.h"

namespace stratareeb {

//! What is predicted at one place before units cut each other.
struct UncutColumn {
    double ground = 0;           // elevation
    std::vector<double> anchor;  // per sequence: elevation of the surface below it; unused where not anchored
    std::vector<double> thickness;  // per unit, >= 0
    std::vector<double> taper;      // per unit: 1 amid holes that have it, 0 beyond its pinch-out line
};

//! Elevations of the bases of all units before they are cut, from the oldest up; not set for units that hang.
std::vector<double> uncut_bases(const UncutColumn& column, std::span<const LayerSequence> sequences);

//! One unit in its place, from the youngest down.
struct PlacedUnit {
    double thickness = 0;  // >= 0
    double clearance = 1;  // of its top above the surface that cuts it off: absent where not above 0
};
PlacedUnit place_unit(const UncutColumn& column, std::span<const double> bases, const LayerSequence& sequence,
                      std::size_t unit, double top);

//! The units' thicknesses once younger ones have cut older ones and gaps are filled.
std::vector<double> stacked_thicknesses(const UncutColumn& column, std::span<const LayerSequence> sequences);

//! Raise what is there but thinner than its minimum. Lower horizons are pushed down only as far as they are in the way:
//! the thickness is taken from the units below, of which each keeps a tenth of its own at least.
void apply_minimum(std::vector<double>& thickness, const LayerRules& rules);

}  // namespace stratareeb
