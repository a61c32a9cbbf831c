// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/hold_out.h"

namespace stratareeb {

//! How much of the drilled length a prediction names rightly, unit by unit, at equal depths below ground. A share of
//! length is the share of samples in the limit of ever closer ones, so no spacing has to be chosen.
struct UnitMatch {
    //! [unit drilled][unit predicted]: length; the last column is what was predicted below the model.
    std::vector<std::vector<double>> length;

    double drilled(std::size_t unit) const;
    double right(std::size_t unit) const { return length[unit][unit]; }
    double share_right() const;  // of all drilled length; 0 where there is none
};

//! Compare held-out holes with what they drilled, from the ground down to the first layer whose thickness they don't know; a
//! layer that a hole ended in counts as far as it went.
UnitMatch match_units(const Survey& survey, std::span<const HeldOutHole> held);

}  // namespace stratareeb
