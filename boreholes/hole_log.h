// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/point.h"

namespace stratareeb {

//! A stretch of a hole with one unit, as a table row gives it. Depths below ground, in survey units.
struct LogInterval {
    static constexpr std::size_t kNoUnit = static_cast<std::size_t>(-1);

    double from = 0, to = 0;
    std::size_t unit = kNoUnit;  // index into LogSet::units; kNoUnit = drilled but not described
    std::size_t row = 0;
    std::uint32_t file = 0;  // index into LogSet::files

    double thickness() const { return to - from; }
};

//! A hole and what was met in it, in any order.
struct HoleLog {
    std::string id;
    Point2 at;
    std::optional<double> ground;  // elevation of depth 0
    std::vector<LogInterval> intervals;
    std::size_t row = 0;     // of the collar
    std::uint32_t file = 0;  // of the collar
};

//! Holes with logs; units are numbered by first appearance.
struct LogSet {
    std::vector<std::string> units;
    std::vector<HoleLog> holes;
    std::vector<std::string> files;
};

//! Bring the intervals of each hole into depth order without overlaps: afterwards each ends where the next
//! begins or above it (a gap). What is done, each with a warning that names the row:
//! - from ≥ to, or a stretch above the ground: left out;
//! - a repeated row: taken as one; two units from the same depth: the shorter first, the longer below it; a
//! row without
//!   a unit gives way to one with;
//! - an overlap: cut at the top of the lower interval; what the upper one has below the lower one's base is
//! not used;
//! - a row without a unit, and a stretch between two intervals that no row covers: unknown (a gap).
//! Neighbours of the same unit become one interval.
void clean_logs(LogSet& logs, Audit& audit);

}  // namespace stratareeb
