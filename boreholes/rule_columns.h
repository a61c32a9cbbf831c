// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "boreholes/complete_columns.h"
#include "boreholes/interpolator.h"
#include "boreholes/layer_rules.h"
#include "boreholes/stacked_column.h"
#include "boreholes/thickness_field.h"

namespace stratareeb {

//! What the holes say under layer rules: full columns, and what stands behind them before younger units cut older ones.
struct RuleColumns {
    CompleteColumns columns;                     // as the holes know them; the rest predicted under the rules
    std::vector<LayerSequence> sequences;        // top first
    std::vector<std::vector<double>> thickness;  // [unit][site], uncut; 0 = absent by nature, not cut away
    std::vector<std::vector<double>> anchor;     // [sequence][site], elevations; empty where not anchored
};

//! Complete columns under options.rules. A unit that a hole lacks under an erosion surface is taken as cut away if it can
//! have been: if the unit below, as thick as elsewhere, reaches up to the surface; else it ends half way, as always.
//! A unit that is cut at a hole was at least as thick as found there.
//! \throw InvalidInput as complete_columns does, and for an eroding, onlapping or base unit that no hole knows.
RuleColumns rule_columns(const Survey& survey, const CompletionOptions& options);

//! Call absent what is thinner than that, and what a hole has, present before the cut too.
void drop_thinner(RuleColumns& rules, double thinnest);

//! The uncut columns at places: elevations by the interpolator, thickness and taper by the field of uncut thicknesses.
//! `ground` is the ground's elevation there.
std::vector<UncutColumn> uncut_columns(const RuleColumns& rules, const ThicknessField& field,
                                       const Interpolator& interpolator, std::span<const Point2> where,
                                       std::span<const double> ground);

}  // namespace stratareeb
