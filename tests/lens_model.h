// SPDX-License-Identifier: GPL-3.0-or-later
// A lens between two layers, and how far its top and base are apart where it ends.
#pragma once

#include <cmath>
#include <utility>

#include "subdivision/body_ends.h"
#include "subdivision/smooth_brep.h"
#include "tests/grid_model.h"

namespace stratareeb::test {

inline double lens(double x, double y) {
    const double r = std::hypot(x - 50, y - 50) / 30;
    return r < 1 - 1e-9 ? 6 * (1 - r * r) : 0;
}

inline LayerModel lens_model(const Field& thickness = lens) {
    return grid_model({.cells = 40,
                       .ground = [](double x, double y) { return 3 * std::sin(x / 13) * std::cos(y / 11); },
                       .thickness = {constant(4), thickness, constant(4)},
                       .rounds = {{50, 50, 30}}});
}

// Places along a curve, ten a span.
template <typename Visit>
void each_place_along(const SplineCurve& curve, const Visit& visit) {
    const auto& breaks = curve.knots.breaks();
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
        for (double k = 0.05; k < 1; k += 0.1) {
            const double t = std::lerp(breaks[s], breaks[s + 1], k);
            visit(t, Point2{curve.at(0, t), curve.at(1, t)});
        }
}

// The least and the largest height of sheet 1 (the lens's top) above sheet 2 (its base) along the lines where the lens ends.
inline std::pair<double, double> gaps_at_ends(const SmoothBrep& brep) {
    double least = INFINITY, most = -INFINITY;
    const auto ends = body_ends(brep.cells, brep.horizons.of_cell);
    for (const BodyEnd& end : ends[1])
        each_place_along(brep.edges[end.edge].curve, [&](double, const Point2& p) {
            const double gap = brep.horizons.sheets[1].z(p) - brep.horizons.sheets[2].z(p);
            least = std::min(least, gap), most = std::max(most, gap);
        });
    return {least, most};
}

// The lines of the edges, as they were moved.
inline PlanCurves curves_of(const LayerModel& model, const SmoothBrep& brep) {
    PlanCurves curves = build_plan_curves(model.plan.surface, brep.cells, 2e-5 * brep.size);
    for (std::size_t e = 0; e < brep.edges.size(); ++e)
        if (const auto line = brep.cells.edges[e].line; line != PlanCells::kNone)
            curves.lines[line].curve = {
                brep.edges[e].curve.knots,
                {brep.edges[e].curve.coefficients[0], brep.edges[e].curve.coefficients[1]}};
    return curves;
}

}  // namespace stratareeb::test
