// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/error_statistics.h"
#include "boreholes/hold_out.h"
#include "boreholes/next_boreholes.h"
#include "boreholes/unit_match.h"

namespace stratareeb {

struct ValidationOptions {
    HoldOutOptions hold_out;
    double confidence = 0.95;  // of intervals and, turned round, of tests
    MeanLaw law = MeanLaw::StudentT;
    std::size_t suggestions = 5;  // places for further holes
};

//! How well one quantity is predicted: the thickness of a layer, or the elevation of a horizon.
struct ItemValidation {
    std::string name;             // the unit's name; "ground", "base of …" for horizons
    ErrorSummary errors, inside;  // of all; of those inside the hull of the holes that were left
    ZTest z;                      // as the thesis tests it: actual and predicted as two samples
    double z_p = 1;               // two-sided
    MeanTest bias;                // of the errors themselves, paired
    std::size_t covered = 0;      // actual values within their intervals
    double mean_half_width = 0;   // of the intervals
    bool certain = true;  // false: too few errors for the confidence, so that the largest one was taken
    std::size_t presence_right = 0;   // layers: holes where present or absent was predicted rightly
    BoundCheck bounds;                // layers: holes that end in it
    std::vector<Residual> residuals;  // in the order of the held-out holes
    std::vector<double> half_width;   // of the interval around each prediction

    double coverage() const {
        return errors.count == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(errors.count);
    }
};

struct Validation {
    std::vector<Draw> draws;
    std::vector<HeldOutHole> held;
    std::vector<ItemValidation> layers;    // thickness; empty for contact points, which know none
    std::vector<ItemValidation> horizons;  // elevation: the ground, then the base of each layer
    MeanTest pooled,
        pooled_naive;     // all thicknesses (contact points: elevations): boreholes as units; each by itself
    double coverage = 0;  // of all intervals of layers and horizons
    UnitMatch units;
    std::size_t crossings = 0;
    std::vector<NextBorehole> next;
};

//! Hold out, predict, and say how well it went.
//! \throw InvalidInput as hold_out does
Validation validate(const Survey& survey, const std::vector<Draw>& draws,
                    const ValidationOptions& options = {});

}  // namespace stratareeb
