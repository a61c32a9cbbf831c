// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reeb/homotopy.h"
#include "reeb/sampled_contour.h"
#include "reeb/strand_surface.h"

namespace stratareeb {

//! The last contour of a strand at one of its ends.
struct CapBase {
    const SampledContour& contour;
    double height = 0;
    bool is_top = true;
};

//! Rows of a cap, from a strand's last contour outwards, to a point of its own for each of its points, at the node's height; neither the
//! contour nor the points are among them. They are closer towards the end, where the width falls like a root, and go on from the contour
//! with the slope that the strand has there (cap_slopes), or as a homotopy by name says (CapProfile).
//! \param homotopy of the strand's rings, if there are two or more
std::vector<SampledContour> cap_rows(const CapBase& base, const std::vector<Point3>& targets,
                                     const Strand& strand, const ContourHomotopy* homotopy,
                                     std::size_t steps);

}  // namespace stratareeb
