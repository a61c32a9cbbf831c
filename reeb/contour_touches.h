// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! A place half way across the gap between two contours.
struct ContourTouch {
    std::size_t first = 0, second = 0;  // contours
    double first_parameter = 0, second_parameter = 0;
    Point3 place;
};

//! Where contours that merge at one height come together, if no single point lies between them all: across the narrowest gaps
//! that join them, one less than there are contours (a minimum spanning tree, so that no gap crosses a third contour).
//! \param height of the places
std::vector<ContourTouch> contour_touches(std::span<const SampledContour> contours, double height);

//! A place that a contour is drawn to.
struct TouchedPlace {
    double parameter = 0;
    Point3 place;
};

//! A contour on its way to the places where it touches others: share 0 is the contour itself, 1 the places' height. Each place is
//! approached along half a quadrant guiding curve, by a tent of at most `reach` that narrows with the gap and before the next place.
//! \pre there are places, all at one height
SampledContour approach_places(const SampledContour& contour, std::span<const TouchedPlace> places,
                               double share, double reach);

}  // namespace stratareeb
