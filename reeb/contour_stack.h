// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A closed ring in the horizontal plane at height z.
struct StackContour {
    double z = 0;
    std::vector<Point2>
        points;        // in either sense; the first may be repeated as the last, and so may any other
    std::string name;  // for messages: where it comes from
};

//! The sections of a body by horizontal planes: contours in any order. At each height, what an odd number of contours lies
//! around is inside the body.
struct ContourStack {
    std::vector<StackContour> contours;
};

//! A stack made plain.
struct SortedStack {
    std::vector<StackContour> contours;  // by height, then by first point; each named, counter-clockwise, no
                                         // point repeated, from its leftmost (of these its lowest) point on
    std::vector<std::uint32_t> source;   // by contour: its place in the stack it came from
    std::vector<std::uint32_t> first;    // by level: its first contour; and the number of contours at the end

    std::size_t levels() const { return first.size() - 1; }
};

//! Which stack it is does not depend on the order of contours, on their sense, or on where they start.
//! \throw InvalidInput with all contours that have no three points apart, no area or numbers that are not finite; and, if
//! there are none, with all that cross or touch themselves or another one of their height.
SortedStack sorted_stack(const ContourStack& stack);

}  // namespace stratareeb
