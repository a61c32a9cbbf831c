// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "reeb/homotopy_weights.h"

namespace stratareeb {

//! How a contour shrinks to the point of a minimum or maximum: its width, as a share of the contour's, over the share x of the
//! height, 0 at the point and 1 at the contour.
class CapProfile {
 public:
    //! A conic, width^2 = c x + (1 - c) x^2, level at the point and with a given slope at the contour, d width / d x, so
    //! that the cap goes on smoothly from there; exact for spheres and ellipsoids. 0 is a half ellipse, the thesis's quadrant; below 0 the
    //! cap bulges out first. Above 0.9, all but a cone, a cubic in the root of x brings the rest of the slope. Slopes are kept within -1 (a sixth
    //! wider than the contour) and 1.8 (width grows all the way).
    static CapProfile conic(double slope);
    //! That of a homotopy's name: linear (a cone), parabola or quadrant from the contour to the point (thesis 2.1.2.3.2);
    //! nothing for the other kinds.
    static std::optional<CapProfile> of(HomotopyKind kind);

    double width(double x) const;

 private:
    CapProfile(HomotopyKind kind, double c, double flare) : kind_(kind), c_(c), flare_(flare) {}

    HomotopyKind kind_;  // Cardinal for a conic
    double c_;
    double flare_;  // slope beyond the conic's
};

}  // namespace stratareeb
