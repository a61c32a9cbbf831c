// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! One separable wave, amplitude · sin(kx x + px) · sin(ky y + py), over local coordinates.
struct Wave {
    double amplitude = 0;
    double kx = 0, px = 0;  // radians per unit of length, radians
    double ky = 0, py = 0;
};

//! A thickness over the square whose integral is known in closed form. Coordinates are local: 0 … extent.
struct TrueThickness {
    enum class Shape {
        Even,    // thickness · (1 + waves), waves small enough to stay positive
        Ramp,    // 0 up to x = inner, then rising linearly to `thickness` at x = outer, even beyond
        Cone,    // a lens: thickness · max(0, 1 − r / outer), r from `center`
        Window,  // even with a round opening: 0 for r ≤ inner, rising linearly, `thickness` for r ≥ outer
    };
    Shape shape = Shape::Even;
    double thickness = 1;
    std::vector<Wave> waves;      // Even
    double inner = 0, outer = 1;  // Ramp: places; Cone, Window: radii, inside the square
    Point2 center;                // Cone, Window
    bool mirrored = false;        // Ramp: rises westward
};

//! A stack of layers known everywhere: what a random survey is drilled into and what a model of it is judged
//! by. It stands on the square corner … corner + (extent, extent).
struct AnalyticTruth {
    Point2 corner;
    double extent = 1;
    double level = 0;  // mean elevation of the ground
    double slope_x = 0, slope_y = 0;
    double dome_height =
        0;  // ground rises by this at the middle, as a paraboloid that is 0 half an extent away
    std::vector<Wave> ground_waves;
    std::vector<TrueThickness> layers;  // top first

    //! Elevation of the ground at a place in survey coordinates.
    double ground(Point2 at) const;

    //! Thickness of a layer (0 = top) there, 0 where it is absent.
    double thickness(std::size_t layer, Point2 at) const;

    //! Exact volume of a layer over the square.
    double volume(std::size_t layer) const;
};

}  // namespace stratareeb
