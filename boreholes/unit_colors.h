// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boreholes/borehole.h"

namespace stratareeb {

//! Colour of the unit at place `order` (0 = top) as "#rrggbb": the same on every run and machine. Neighbours
//! differ in hue and in lightness, so that they stay apart in print and for colour-blind eyes. Never repeats
//! within 120 units.
std::string unit_color(std::size_t order);

//! Fill in the colour of each unit that has none.
void color_units(std::vector<Unit>& units);

}  // namespace stratareeb
