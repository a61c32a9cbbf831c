// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_profile.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {
constexpr double kSteepestSlope = 0.9;
}  // namespace

// The conic's slope at x = 1 is 1 - c / 2.
CapProfile CapProfile::conic(double slope) {
    return CapProfile(HomotopyKind::Cardinal, 2 - 2 * std::clamp(slope, 0.0, kSteepestSlope));
}

std::optional<CapProfile> CapProfile::of(HomotopyKind kind) {
    switch (kind) {
        case HomotopyKind::Linear:
        case HomotopyKind::Parabola:
        case HomotopyKind::Quadrant:
            return CapProfile(kind, 0);
        default:
            return std::nullopt;
    }
}

double CapProfile::width(double x) const {
    const double t = 1 - x;  // from the contour
    switch (kind_) {
        case HomotopyKind::Linear:
            return x;
        case HomotopyKind::Parabola:
            return 1 - t * t;
        case HomotopyKind::Quadrant:
            return std::sqrt(1 - t * t);
        default:
            return std::sqrt(c_ * x + (1 - c_) * x * x);
    }
}

}  // namespace stratareeb
