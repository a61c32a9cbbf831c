// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/interpolator.h"

namespace stratareeb {

//! [hole][horizon]: elevations that each hole gives, or that follow from one above by thicknesses measured in between.
//! `ground` is used where a hole gives none; of contact points nothing follows.
std::vector<std::vector<std::optional<double>>> known_elevations(const Survey& survey,
                                                                 std::span<const double> ground);

//! Elevations at all sites: known ones as they are, the others predicted from them, no lower than `lowest` (empty, or
//! by site) where that is given. Methods that take bounds let them tell on other sites too.
//! \pre at least one is known.
std::vector<double> completed_elevations(std::span<const Point2> sites,
                                         std::span<const std::optional<double>> known, InterpolatorKind kind,
                                         std::span<const std::optional<double>> lowest = {});

}  // namespace stratareeb
