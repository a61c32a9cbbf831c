// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"
#include "boreholes/hole_log.h"

namespace stratareeb {

//! What becomes of a unit that comes back lower down in the same hole, or stands out of the column's order.
enum class RepeatRule {
    Absorb,  // each hole keeps its heaviest chain of units in order; the rest goes to the kept unit above
    Split,   // the k-th occurrence is a unit of its own, "sand (2)"; what is still out of order is absorbed
};

struct StratigraphyOptions {
    std::vector<std::string>
        order;  // unit codes from top to bottom; empty = inferred from who lies above whom
    RepeatRule repeats = RepeatRule::Absorb;
};

//! Turn logs into facts about one column of units.
//! A unit above the deepest one met in a hole is absent there, one below is unknown. The deepest interval
//! ends with the hole: at least that thick. In a gap, units that lie between its neighbours in the order are
//! unknown, its two ends are contacts; if no unit lies between, the two neighbours are at least as thick as
//! seen. A log that begins below the ground has a gap on top; if more than a fifth of the holes do, a first
//! unit "overburden" holds it. Elevations are known where the hole's ground is. Holes without intervals keep
//! their ground.
//! \throw InvalidInput for more than 500 units: the unit column then is no unit column.
Survey build_survey(LogSet logs, const StratigraphyOptions& options, Audit& audit);

}  // namespace stratareeb
