// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "boreholes/analytic_truth.h"
#include "boreholes/borehole.h"

namespace stratareeb {

//! How holes are spread over the square.
enum class HolePlan {
    Random,     // evenly at random
    Clustered,  // in groups, as site investigations are
    Grid,       // a square grid: four holes on a circle everywhere
    Line,       // along a diagonal, off it by a thousandth of the extent: nearly collinear
};

//! What the holes are drilled into.
enum class TruthKind {
    Slab,     // level ground, even layers
    Dipping,  // a plane, even layers
    Wedge,    // level ground, layers thinning out to nothing to the west and to the east in turn
    Dome,     // a paraboloid, even layers
    Lens,     // level ground, even layers; every second one is a cone-shaped lens
    Random,   // rolling ground, layers of smoothly varying thickness
};

struct RandomSurveyOptions {
    std::size_t holes = 52;  // at least 3; 52 holes in 3 layers are the size of the thesis's test
    std::size_t layers = 3;
    std::uint64_t seed = 1;
    double extent = 300;    // side of the square
    Point2 corner = {};     // its south-west corner, as {5e6, 5e6} for map coordinates
    double level = 100;     // mean elevation of the ground
    double thickness = 20;  // of a layer where it is not thinned
    HolePlan plan = HolePlan::Random;
    TruthKind truth = TruthKind::Random;
    bool pinch_outs = false;  // random truth: all layers but the first end somewhere
    bool corners = true;  // random and clustered plans of 4 holes or more: four of them stand in the corners,
                          // so that the holes' hull is the square which the true volumes are about
    double resolution =
        0.001;  // x, y, elevations and thicknesses are multiples of it, as in a log; 0 = as computed

    // Chances per cell or hole of facts that the truth does not have; they make hostile input for tests.
    double zero_share = 0;     // cells called absent
    double unknown_share = 0;  // cells that say nothing
    double cut_off_share = 0;  // holes that end inside a layer
};

//! The truth that `random_survey` with the same options drills into.
//! \throw InvalidInput for options that make no sense.
AnalyticTruth random_truth(const RandomSurveyOptions& options);

//! Boreholes at random places, no two at the same one, with what they find in `random_truth(options)`.
//! The same options give the same survey with every compiler; time grows as holes · log(holes).
//! \throw InvalidInput for options that make no sense, such as more holes than the square has places.
Survey random_survey(const RandomSurveyOptions& options = {});

}  // namespace stratareeb
