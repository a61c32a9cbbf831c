// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "reeb/toroidal_graph.h"

namespace stratareeb {

//! A contour as a curve: its point at any parameter in [0, 1], and the parameters at which a triangulation should have points.
struct SampledCurve {
    std::function<Point3(double)> at;  // closed curves: at(1) would be at(0) and is not asked for
    std::vector<double> parameters;    // in any order; closed curves: modulo 1
};

//! A band between two curves, with the parameters and points that its triangles use.
struct ContinuousBand {
    std::vector<double> upper_parameters, lower_parameters;  // ascending
    std::vector<Point3> upper, lower;
    Band band;

    //! The path in the continuous toroidal graph, span by span: parameters of the upper and the lower end. Both never
    //! decrease; on closed curves they go on beyond 1 and end one turn after the start.
    std::vector<std::array<double, 2>> path() const;

    bool closed = true;
};

//! The continuous toroidal graph (Y. Shinagawa, T. Kunii 1991; thesis, 2.1.2.2.2): both axes are parameters, so that spans may
//! end anywhere on the curves, not at their own samples only. Each curve is sampled at the other's parameters too, which makes
//! every span at equal parameters one of the graph; then the discrete problem is solved on that. Parametric distances are
//! taken between these parameters. `options.upper_parameters` and `lower_parameters` are not used.
//! \throw InvalidInput
//! if both have no parameters, one is not a number, or is outside [0, 1] on an open curve; and as toroidal_band does.
ContinuousBand continuous_band(const SampledCurve& upper, const SampledCurve& lower,
                               BandOptions options = {});

}  // namespace stratareeb
