// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_profile.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {
constexpr double kLeastSlope = -1, kMostSlopeOfConic = 0.9, kMostSlope = 1.8;
}  // namespace

// The conic's slope at x = 1 is 1 - c / 2.
CapProfile CapProfile::conic(double slope) {
    const double kept = std::clamp(slope, kLeastSlope, kMostSlope),
                 of_conic = std::min(kept, kMostSlopeOfConic);
    return CapProfile(HomotopyKind::Cardinal, 2 - 2 * of_conic, kept - of_conic);
}

std::optional<CapProfile> CapProfile::of(HomotopyKind kind) {
    switch (kind) {
        case HomotopyKind::Linear:
        case HomotopyKind::Parabola:
        case HomotopyKind::Quadrant:
            return CapProfile(kind, 0, 0);
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
        default: {
            // Hermite's cubic in u = sqrt(x): 0 at both ends, level at u = 0, slope 1 over x at u = 1.
            const double u = std::sqrt(x), bend = 2 * x * (u - 1);
            return std::sqrt(c_ * x + (1 - c_) * x * x) + flare_ * bend;
        }
    }
}

}  // namespace stratareeb
