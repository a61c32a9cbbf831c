// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! How a hole knows a layer's thickness. Absent, unknown and "at least" are three different facts:
//! absent is Measured with thickness 0.
enum class Knowledge {
    Unknown,   // the hole says nothing: an empty cell, or the hole ended above
    AtLeast,   // the hole ended inside the layer: `thickness` is a lower bound, > 0
    Measured,  // `thickness` is the thickness, 0 where the layer is absent
};

//! What one hole says of one layer. Thickness in survey units, never negative.
struct LayerFact {
    Knowledge knowledge = Knowledge::Unknown;
    double thickness = 0;

    bool is_absent() const { return knowledge == Knowledge::Measured && thickness == 0; }
    bool is_present() const { return knowledge != Knowledge::Unknown && thickness > 0; }
};

//! One layer of the stratigraphic column.
struct Unit {
    std::string code;   // as in the table
    std::string name;   // for people; the code where nothing better is known
    std::string color;  // "#rrggbb"
};

//! A vertical hole: a place in plan and what is known below it.
//! `layers[i]` is about unit i (0 = top). `horizons[k]` is an elevation where it is known: k = 0 the ground,
//! k = i + 1 the base of unit i. Where all layers down to k are Measured, horizons[k] follows from them; a contact
//! point gives a single horizon and no layer.
struct Borehole {
    std::string id;
    Point2 at;
    std::vector<LayerFact> layers;
    std::vector<std::optional<double>> horizons;  // layers.size() + 1
    std::size_t row = 0;                          // of the table, for messages; 0 = none
};

//! A set of holes against one stratigraphic column, top first. Elevations are up, all in the same unit of length.
struct Survey {
    std::vector<Unit> units;
    std::vector<Borehole> holes;
    bool contact_points = false;    // holes are single contacts: predict elevations, not thicknesses
    std::string length_unit = "m";  // of x, y, z and thickness alike: "m", "ft" or "us-ft"
};

}  // namespace stratareeb
