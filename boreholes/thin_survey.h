// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "boreholes/borehole.h"

namespace stratareeb {

struct ThinOptions {
    double error = 0;  // go on until no contact that is left out is missed by more, in survey units
    std::optional<std::size_t>
        count;  // and have no more holes than this, if given; the hull's stay in any case
    //! Called with the number of holes that are in.
    std::function<void(std::size_t kept)> progress = {};
};

struct ThinnedSurvey {
    std::vector<std::size_t> kept;  // of the survey's holes, ascending
    double largest_error = 0;       // of contacts of holes that were left out
    double rms_error = 0;
};

//! The holes that say most: those of the hull, then, one after the other, the hole whose contacts the plane pieces
//! between those before it miss by most (greedy insertion: M. Garland and P. Heckbert, Fast polygonal approximation of terrains,
//! 1995; here for all horizons at once). Contacts that a hole does not know don't count; as a corner of the planes it has them as
//! complete_columns gives them.
//! \throw InvalidInput for an error below 0, a count below 3, or holes that all stand in a line
ThinnedSurvey thin_survey(const Survey& survey, const ThinOptions& options);

}  // namespace stratareeb
