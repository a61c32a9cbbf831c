// SPDX-License-Identifier: GPL-3.0-or-later
// Rings around plan regions, and bodies whose saddles differ.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/plan_sheet.h"

namespace stratareeb::testing {

inline std::vector<Point3> wavy_ring(double x, double y, double z, double radius, int corners = 40,
                                     double wave = 0, int waves = 5, double phase = 0) {
    std::vector<Point3> ring;
    for (int i = 0; i < corners; ++i) {
        const double u = 2 * std::numbers::pi * i / corners,
                     r = radius * (1 + wave * std::sin(waves * u + phase));
        ring.push_back({x + r * std::cos(u), y + r * std::sin(u), z});
    }
    return ring;
}

//! Summits that rise side by side over one contour: an outer lower ring and some upper ones in a circle.
inline std::vector<SheetRing> summits(int count, double wave = 0, double phase = 0) {
    std::vector<SheetRing> rings{{wavy_ring(0, 0, 0, 10, 90, wave / 3, 7, phase), true, false}};
    for (int k = 0; k < count; ++k) {
        const double u = 2 * std::numbers::pi * (k + 0.1 * phase) / count;
        rings.push_back({wavy_ring(5 * std::cos(u), 5 * std::sin(u), 2, 4.0 / count, 36, wave, 5, phase + k),
                         false, false});
    }
    return rings;
}

}  // namespace stratareeb::testing
