// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"
#include "boreholes/stratigraphy.h"

namespace stratareeb {

enum class ListedValue { Thickness, BaseDepth, BaseElevation };

//! What one row says of one unit.
struct ListedLayer {
    std::size_t unit = 0;   // index into ListedSet::units
    bool given = false;     // false: an empty cell
    bool at_least = false;  // marked as a lower bound
    double value = 0;       // of the kind ListedSet::value
};

//! One row of a wide table: a hole with its layers from top to bottom.
struct ListedHole {
    std::string id;
    Point2 at;
    std::optional<double> ground;
    std::vector<ListedLayer> layers;
    std::size_t row = 0;
    std::uint32_t file = 0;
};

struct ListedSet {
    std::vector<std::string> units;  // by first appearance
    std::vector<ListedHole> holes;
    std::vector<std::string> files;
    ListedValue value = ListedValue::Thickness;
    bool of_tops = false;  // depths and elevations are of each unit's top instead of its base
};

//! Turn rows of layers into facts about one column of units, in the stated order or the one that the rows
//! list. 0 is absent; a layer without a value is unknown. A unit that a row does not list is absent above the
//! deepest value of the row and unknown below. If anything below the deepest value is unknown, the hole ended
//! in that layer: at least that thick. Units that a row lists out of order or twice follow options.repeats,
//! as in logs. Depths and elevations that turn back upwards are unknown, with a warning. Of tops: what lies
//! above the first is the unit "overburden"; the last unit has no base and is no layer.
Survey build_survey(ListedSet listed, const StratigraphyOptions& options, Audit& audit);

}  // namespace stratareeb
