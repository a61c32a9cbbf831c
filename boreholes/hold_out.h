// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "boreholes/block_ties.h"
#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"
#include "boreholes/hold_out_draws.h"

namespace stratareeb {

struct HoldOutOptions {
    CompletionOptions prediction;
    bool bare = false;  // see ColumnPredictor
    //! Block between faults, by hole: a hole is predicted from its own block's holes alone (block_survey.h). Empty = no faults.
    std::vector<std::uint32_t> block;
    std::vector<BlockTie> ties;  // where faults die out between blocks
    //! Called with the share of draws done, from one thread at a time, but from different ones.
    std::function<void(double share)> progress;
};

//! What the other holes say of one that was left out.
struct HeldOutHole {
    std::size_t hole = 0, draw = 0;
    bool inside = false;            // in the hull of the holes that were left
    std::vector<double> thickness;  // per layer, >= 0
    std::vector<double> horizons;   // elevations: 0 the ground, k = i + 1 the base of layer i
};

//! Leave out each draw in turn, predict its holes from the rest as a layer model of the rest would, and put them back.
//! In the order of draws, and of holes in a draw; the same with any number of threads.
//! \throw InvalidInput if the rest can't carry a prediction; the message names the draw.
std::vector<HeldOutHole> hold_out(const Survey& survey, const std::vector<Draw>& draws,
                                  const HoldOutOptions& options = {});

//! Draws of contact points without those that are the last to know a horizon: without them it could not be predicted at all.
//! Other surveys' draws are returned as they are; draws that end up empty are left out.
std::vector<Draw> without_last_contacts(const Survey& survey, std::vector<Draw> draws);

//! Draws without the first hole of each block that they would leave without a hole; see HoldOutOptions::block.
std::vector<Draw> without_whole_blocks(std::span<const std::uint32_t> block, std::vector<Draw> draws);

//! An actual number of a hole beside what was predicted for it.
struct Residual {
    std::size_t held = 0;  // index into the list of held-out holes
    std::size_t hole = 0, draw = 0;
    std::size_t item = 0;  // layer, or horizon
    double actual = 0, predicted = 0;
    bool inside = false;

    double error() const { return predicted - actual; }
};

//! Thickness of one layer at all held-out holes that measured it, absent (0) included.
std::vector<Residual> thickness_residuals(const Survey& survey, std::span<const HeldOutHole> held,
                                          std::size_t layer);

//! Elevation of horizon k at all held-out holes that know it.
std::vector<Residual> elevation_residuals(const Survey& survey, std::span<const HeldOutHole> held,
                                          std::size_t k);

//! Holes that end in a layer know a lower bound. How often a prediction is below it, and by how much in all.
struct BoundCheck {
    std::size_t bounds = 0, below = 0;
    double shortfall = 0;  // sum over those below
};
BoundCheck check_bounds(const Survey& survey, std::span<const HeldOutHole> held, std::size_t layer);

//! Predicted neighbouring horizons of which the upper lies below the lower. Columns hang from the ground by thicknesses
//! that are never negative, so that this is 0; it is counted nevertheless.
std::size_t count_crossings(std::span<const HeldOutHole> held);

}  // namespace stratareeb
