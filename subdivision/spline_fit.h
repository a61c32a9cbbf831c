// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "subdivision/cubic_knots.h"

namespace stratareeb {

//! Several coordinates as cubic splines of one parameter.
struct SplineCurve {
    CubicKnots knots;
    std::vector<std::vector<double>> coefficients;  // [coordinate][function]

    double at(std::size_t coordinate, double t, int derivative = 0) const {
        return knots.evaluate(coefficients[coordinate], t, derivative);
    }
};

struct SplineFitOptions {
    double tolerance = 0;           // largest distance wanted at the samples
    std::size_t most_spans = 1000;  // the fit is returned as it is when they are used up
    double resolution = 0;          // approximate: a function has no features shorter than that
};

//! A curve near samples at ascending parameters, through the first and the last: least squares with a little
//! bending energy, spans halved where a sample is off by more than the tolerance.
//! \param samples [coordinate][i] at parameters[i]; at least two.
SplineCurve fit_spline(const std::vector<double>& parameters, const std::vector<std::vector<double>>& samples,
                       const SplineFitOptions& options);

//! The spline of the given knots that equals f at all Greville points. It is f itself where f is such a spline.
std::vector<double> interpolate_spline(const CubicKnots& knots, const std::function<double(double)>& f);

//! A spline near a function, of spans that are halved until it is off by no more than the tolerance at points
//! between; `knots` are the spans to begin with.
SplineCurve approximate(const CubicKnots& knots, const std::function<double(double)>& f,
                        const SplineFitOptions& options);

}  // namespace stratareeb
