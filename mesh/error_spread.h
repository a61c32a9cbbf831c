// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! What boreholes know and a model says everywhere.
struct PredictedQuantity {
    bool thickness = false;  // of layer `index`; otherwise the elevation of horizon `index` (0 = ground)
    std::size_t index = 0;
};

enum class Spread {
    Deviation,  // standard deviation of the error
    Interval,   // half the width of the interval that holds the truth with a given confidence
};

struct ErrorSpreadOptions {
    CompletionOptions prediction;  // as the model was made
    double confidence = 0.95;      // of the interval
    std::size_t folds = 10;        // of the hold-out; fewer holes: each by itself
    std::uint64_t seed = 1;
};

struct ErrorSpread {
    std::vector<double> size;  // by plan vertex
    std::size_t errors = 0;    // that it was made from
    bool certain =
        true;  // interval: there are errors enough for the confidence; otherwise the largest is taken
};

//! How far off a model may be, at each vertex of its plan, from boreholes left out and predicted by the others: errors grow with the
//! distance of the nearest hole that knows the quantity and are larger where their neighbours are (LocalError). Holes are left out one
//! by one and, where places are farther from holes than those are from each other, in groups too (matched_draws). The interval is conformal
//! (PredictionReach); the deviation is the local size times the root mean square of errors over it, but no larger than the 95 % interval
//! makes it for normal errors. Nearer to a hole than any left-out hole was to another, and farther than all, they change with the root of the
//! distance, as for a linear variogram; at the holes, which the model meets, they are 0.
//! \throw InvalidInput if fewer than 5 left-out holes know the quantity, or as hold_out does
ErrorSpread error_spread(const LayerModel& model, const Survey& survey, const PredictedQuantity& quantity,
                         Spread spread, const ErrorSpreadOptions& options = {});

}  // namespace stratareeb
