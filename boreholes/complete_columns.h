// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/interpolator.h"
#include "boreholes/layer_rules.h"
#include "boreholes/pinch_out.h"

namespace stratareeb {

//! A full column at every hole: what was measured as it is, what was not as predicted.
struct CompleteColumns {
    std::vector<Point2> sites;                   // the survey's holes, in order
    std::vector<double> ground;                  // elevation, per site
    std::vector<std::vector<double>> thickness;  // [layer][site], >= 0; 0 = absent
    //! [layer][site]: the thickness there is found or follows from what is, or is a bound above what the others predict; 0 = it is
    //! predicted itself. Empty: all are.
    std::vector<std::vector<char>> known;
    std::vector<std::string> notes;  // what had to be assumed, for people
};

struct CompletionOptions {
    InterpolatorKind interpolator = kDefaultInterpolator;
    PinchOutRule pinch_out;
    //! Elevation of a terrain model; gives the ground where a hole does not.
    std::function<std::optional<double>(const Point2&)> terrain;
    LayerRules rules = {};  // for rule_columns; complete_columns takes all units as conformable
};

//! Predict what holes don't know from those that do, layer by layer:
//! an unknown thickness from the measured ones; a thickness known to be "at least" so much as the larger of
//! that and the prediction. A layer that no hole drills through takes its "at least" thicknesses as they are.
//! Where a hole gives the elevations at both ends of an unknown part, the predicted thicknesses are scaled to
//! fit. Surveys of contact points predict elevations, horizon by horizon, keep the contacts and order the
//! rest between them.
//! \throw InvalidInput if there is no hole or no ground anywhere.
CompleteColumns complete_columns(const Survey& survey, const CompletionOptions& options = {});

}  // namespace stratareeb
