// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"

namespace stratareeb {

//! A place beyond the end of a fault, where blocks to its two sides are one. What the holes of all of them predict there counts
//! for each as if it were a hole of its own, so that they agree there.
struct BlockTie {
    Point2 at;
    std::vector<std::uint32_t> from;  // blocks whose holes predict the column, ascending
    std::vector<std::uint32_t> to;    // blocks for which it counts, ascending
};

//! The columns at ties, as fully known holes. `block_of`: block by hole of the survey; `bare`: see ColumnPredictor.
//! Ties whose blocks have no hole left are left out.
//! \return by block: the columns that count for it
//! \throw as ColumnPredictor
std::vector<std::vector<Borehole>> tie_columns(const Survey& survey, std::span<const std::uint32_t> block_of,
                                               std::span<const BlockTie> ties,
                                               const CompletionOptions& options, bool bare);

}  // namespace stratareeb
