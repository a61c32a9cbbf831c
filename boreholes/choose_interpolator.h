// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/block_ties.h"
#include "boreholes/borehole.h"
#include "boreholes/interpolator.h"
#include "boreholes/layer_rules.h"
#include "boreholes/pinch_out.h"

namespace stratareeb {

struct ChooseOptions {
    //! Simple ones first: of equals the first is taken.
    std::vector<InterpolatorKind> candidates{
        InterpolatorKind::Linear,  InterpolatorKind::NaturalNeighbour, InterpolatorKind::Spline,
        InterpolatorKind::Kriging, InterpolatorKind::KrigingLinear,    InterpolatorKind::KrigingQuadratic};
    std::size_t folds = 10;
    std::uint64_t seed = 1;
    std::size_t most_holes =
        1000;  // so many holes, drawn at random, are held out in all; the others always stay
    //! As the model will be built.
    PinchOutRule pinch_out;
    std::function<std::optional<double>(const Point2&)> terrain = {};
    LayerRules rules = {};
    std::vector<std::uint32_t> block = {};  // by hole, see HoldOutOptions
    std::vector<BlockTie> ties = {};        // see HoldOutOptions
    bool bare = false;
    //! Called with the share done, from one thread at a time, but from different ones.
    std::function<void(double share)> progress = {};
};

//! How well one method predicts holes that it hasn't seen.
struct InterpolatorScore {
    InterpolatorKind kind;
    std::vector<double> rmse;  // by quantity, in survey units
    double ratio = 1;          // geometric mean over the quantities of rmse / the first candidate's
};

struct InterpolatorChoice {
    InterpolatorKind kind;
    std::vector<std::string> quantities;    // "thickness of 'sand'", "base of 'sand'", …
    std::vector<std::size_t> held_out;      // holes, by quantity
    std::vector<InterpolatorScore> scores;  // in the order of the candidates
    std::string reason;                     // a sentence
};

//! The candidate with the least error when boreholes are left out, draw by draw, and predicted from the rest as a model of the
//! rest would (hold_out.h): of the thickness of each layer and the elevation of its base that 5 held-out holes or more know;
//! of contact points, of elevations. Of holes at one place the first is taken. A survey of fewer than 5 holes, or with nothing
//! to tell candidates apart by, gets the first.
//! \throw InvalidInput if there are no candidates or fewer than two folds.
InterpolatorChoice choose_interpolator(const Survey& survey, const ChooseOptions& options = {});

}  // namespace stratareeb
