// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/vertical_section.h"

namespace stratareeb {

//! What a hole found between two elevations.
struct LogInterval {
    std::size_t layer = 0;
    double top = 0, base = 0;
    bool goes_on = false;  // the hole ended in the layer: it is at least so thick
};

//! A hole beside a section's line.
struct SectionHole {
    std::string id;
    double along = 0;              // of the nearest place on the line
    double aside = 0;              // distance from the line
    double top = 0;                // the hole's ground
    std::vector<LogInterval> log;  // what it says itself, top first; unknown parts are left out
};

//! A hole's own log in elevations. Layers whose top and base are not both known are left out.
std::vector<LogInterval> log_of(const Borehole& hole);

//! Holes no farther than `within` from the section's line that know their ground, left to right.
std::vector<SectionHole> holes_along(const VerticalSection& section, const Survey& survey, double within);

//! The line through holes of these names, in their order.
//! \throw InvalidInput naming a hole that is not there, with the most similar names
std::vector<Point2> line_through(const Survey& survey, const std::vector<std::string>& ids);

}  // namespace stratareeb
