// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "boreholes/plan_box.h"
#include "boreholes/point.h"
#include "subdivision/cubic_knots.h"

namespace stratareeb {

//! A smooth height over a rectangle in plan: a bicubic B-spline surface whose parameters are x and y
//! themselves, so that a curve in plan is its own curve in parameter space.
struct HeightPatch {
    CubicKnots x, y;
    std::vector<double> coefficients;  // [function of x][function of y]

    double z(const Point2& p) const;
    Point2 gradient(const Point2& p) const;  // dz/dx, dz/dy
};

//! Lower a patch at a place, by the least change of coefficients (S. Kaczmarz, 1937).
//! \return at least what it rises by anywhere
double lower_at(HeightPatch& patch, const Point2& at, double by);

//! The same for its slope in a direction of unit length.
double tilt_at(HeightPatch& patch, const Point2& at, const Point2& direction, double by);

//! A height that a patch is to have at a place.
struct HeightSample {
    Point2 at;
    double z = 0;
    double weight = 1;     // the plan area that it stands for, or a share of a border sample
    double tolerance = 1;  // how far off it may be
    double highest = std::numeric_limits<double>::infinity();  // the patch is to stay below; >= z
};

//! What coefficients of a patch may be at most for the knots that a fit came to, [function of x][function of y]; infinity =
//! anything.
using LimitMaker = std::function<std::vector<double>(const CubicKnots& x, const CubicKnots& y)>;

struct HeightFitOptions {
    double finest = 0;  // spans shorter than this are not halved
    //! Spans to begin with, over all samples and more; those beyond the samples are left out.
    CubicKnots x{{0, 1}}, y{{0, 1}};
    std::size_t most_functions = 40'000;
    //! Of a border sample at first, in mean weights of one inside; more where the patch misses it.
    double border_weight = 300;
    LimitMaker limits;  // none if empty: samples' highest count with them only
};

struct HeightFit {
    HeightPatch patch;
    double off_inside = 0, off_border = 0;  // largest distance at samples
    std::vector<char> held;                 // [coefficient] whether it is at its limit; empty without limits
    std::vector<double> border_weights;     // [border sample] in mean weights of one inside
};

struct HeightSamples {
    std::vector<HeightSample> inside;  // to be met
    std::vector<HeightSample> border;  // to be met most closely
    //! That cover the place the patch is for; elsewhere it is to be as straight as it can. Empty = everywhere.
    std::vector<PlanBox> covered;
};

//! Fit a patch to samples: least squares with just as much bending energy as decides where there are no samples
//! (beyond the outline that the patch is trimmed to), border samples far above the others. Rows and columns of
//! spans are halved until the tolerances are met, or spans are as fine as they may be.
//! \throw GeometryError if the equations can't be solved.
HeightFit fit_height_patch(const HeightSamples& samples, const HeightFitOptions& options);

//! The same for other heights of the samples, with the spans that a fit came to. Limits as in the fit.
HeightFit refit_height_patch(const HeightSamples& samples, const HeightFit& fit,
                             const LimitMaker& limits = {});

}  // namespace stratareeb
