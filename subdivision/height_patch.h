// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/cubic_knots.h"

namespace stratareeb {

//! A smooth height over a rectangle in plan: a bicubic B-spline surface whose parameters are x and y
//! themselves, so that a curve in plan is its own curve in parameter space.
struct HeightPatch {
    CubicKnots x, y;
    std::vector<double> coefficients;  // [function of x][function of y]

    double z(const Point2& p) const;
};

//! A height that a patch is to have at a place.
struct HeightSample {
    Point2 at;
    double z = 0;
    double weight = 1;     // the plan area that it stands for, or a share of a border sample
    double tolerance = 1;  // how far off it may be
};

struct HeightFitOptions {
    double tolerance = 0;         // largest distance wanted at the samples, in the unit of z
    double border_tolerance = 0;  // the same for samples on the border
    double finest = 0;            // spans shorter than this are not halved
    std::size_t most_functions = 40'000;
};

struct HeightFit {
    HeightPatch patch;
    double off_inside = 0, off_border = 0;  // largest distance at samples
};

struct HeightSamples {
    std::vector<HeightSample> inside;  // to be met
    std::vector<HeightSample> border;  // to be met most closely
    std::vector<HeightSample> guides;  // what is known roughly in between; not measured
};

//! Fit a patch to samples: least squares with just as much bending energy as decides where there are no samples
//! (beyond the outline that the patch is trimmed to), border samples far above the others. Rows and columns of
//! spans are halved until the tolerances are met, or spans are as fine as they may be.
//! \throw GeometryError if the equations can't be solved.
HeightFit fit_height_patch(const HeightSamples& samples, const HeightFitOptions& options);

}  // namespace stratareeb
