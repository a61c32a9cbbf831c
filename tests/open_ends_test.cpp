// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/open_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/grid_model.h"
#include "tests/lens_model.h"

namespace stratareeb {
namespace {

using test::gaps_at_ends;
using test::lens_model;

constexpr double kGap = 1e-3;

TEST(OpenEnds, are_where_a_base_came_through_its_top_and_nowhere_else) {
    const auto model = lens_model();
    SmoothBrep brep = build_smooth_brep(model, {.sheets = {.end_gap = 1e-6}});
    const Point2 at_edge{80, 50}, inside{50, 50};
    lower_at(brep.horizons.sheets[2], at_edge, -0.1);
    ASSERT_LT(gaps_at_ends(brep).first, -0.05);
    const double before = brep.horizons.sheets[2].z(inside);
    const PlanCurves curves = test::curves_of(model, brep);
    brep.horizons.gaps.assign(brep.cells.bodies.size(), kGap);
    open_body_ends(brep.horizons, model, brep.cells, curves);
    EXPECT_GT(gaps_at_ends(brep).first, 0.25 * kGap);
    EXPECT_LT(gaps_at_ends(brep).second, 0.2);
    EXPECT_EQ(brep.horizons.sheets[2].z(inside), before);
}

struct Inwards {
    double least_open = INFINITY;     // of top above base in a strip inside the ends
    double least_opening = INFINITY;  // slope of the thickness at the ends, inwards
};

// Of the lens, along all its ends and up to a metre inside, less near the ends of lines, where others are near.
Inwards inwards_of(const SmoothBrep& brep) {
    Inwards result;
    const HeightPatch &top = brep.horizons.sheets[1], &base = brep.horizons.sheets[2];
    const auto& cells = brep.cells;
    for (const auto c : cells.bodies[1].base)
        for (const auto& loop : cells.cells[c].loops)
            for (const auto& use : loop) {
                const SplineCurve& curve = brep.edges[use.edge].curve;
                const double first = curve.knots.low(), last = curve.knots.high();
                test::each_place_along(curve, [&](double t, const Point2& p) {
                    Point2 n{-curve.at(1, t, 1), curve.at(0, t, 1)};
                    const double length = std::hypot(n.x, n.y) * (use.forward ? 1 : -1);
                    n = {n.x / length, n.y / length};
                    const Point2 g = top.gradient(p), h = base.gradient(p);
                    result.least_opening =
                        std::min(result.least_opening, (g.x - h.x) * n.x + (g.y - h.y) * n.y);
                    const double reach = std::min({1.0, 0.4 * (t - first), 0.4 * (last - t)});
                    for (double d = 0; d < reach; d += 0.07) {
                        const Point2 q{p.x + d * n.x, p.y + d * n.y};
                        result.least_open = std::min(result.least_open, top.z(q) - base.z(q));
                    }
                });
            }
    return result;
}

// Lenses that end steeply, slowly, with no slope at all, and roughly.
TEST(OpenEnds, open_inwards_however_a_lens_ends) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> rough(0.5, 1.5);
    for (int shape = 0; shape < 6; ++shape) {
        const auto thickness = [&](double x, double y) {
            const double r = std::hypot(x - 50, y - 50) / 30, in = 1 - r * r;
            if (!(r < 1 - 1e-9)) return 0.0;
            switch (shape) {
                case 0:
                    return 6 * in;
                case 1:
                    return 6 * in * in;
                case 2:
                    return 6 * in * in * in;
                case 3:
                    return 0.05 * in;
                default:
                    return 3 * in * in * rough(random);
            }
        };
        SCOPED_TRACE(shape);
        const SmoothBrep brep = build_smooth_brep(lens_model(thickness), {.sheets = {.end_gap = 1e-6}});
        const Inwards inwards = inwards_of(brep);
        EXPECT_GT(inwards.least_open, 0);
        EXPECT_GT(inwards.least_opening, 2e-4);
        EXPECT_GT(brep.horizons.least_thickness[1], 0);
    }
}

// Where the end of a layer turns back, what is inside lies beside none of its lines.
TEST(OpenEnds, open_around_the_corner_of_a_notch) {
    const auto model =
        test::grid_model({.cells = 24,
                          .ground = [](double x, double y) { return std::sin(x / 20) + y / 30; },
                          .thickness = {test::constant(4),
                                        [](double x, double y) {
                                            return 0.05 * std::max({0.0, 50 - x, 50 - y});
                                        },
                                        test::constant(3)}});
    SmoothBrep brep = build_smooth_brep(model, {.sheets = {.end_gap = 1e-6}});
    const auto least_open = [&] {
        double least = INFINITY;
        for (double r = 0.1; r < 1.4; r += 0.05)
            for (double angle = 110; angle <= 340; angle += 5) {
                const double a = angle * std::numbers::pi / 180;
                const Point2 p{50 + r * std::cos(a), 50 + r * std::sin(a)};
                least = std::min(least, brep.horizons.sheets[1].z(p) - brep.horizons.sheets[2].z(p));
            }
        return least;
    };
    const Point2 inside{49.4, 49.4};
    lower_at(brep.horizons.sheets[2], inside,
             brep.horizons.sheets[2].z(inside) - brep.horizons.sheets[1].z(inside) - 0.05);
    ASSERT_LT(least_open(), -0.01);
    const PlanCurves curves = test::curves_of(model, brep);
    open_body_ends(brep.horizons, model, brep.cells, curves);
    EXPECT_GT(least_open(), 0);
}

// What a CAD program compares at an edge: the base of a lens that shrinks inwards at first.
TEST(OpenEnds, tilt_a_base_that_leans_the_wrong_way) {
    const auto model = lens_model();
    SmoothBrep brep = build_smooth_brep(model, {.sheets = {.end_gap = 1e-6}});
    tilt_at(brep.horizons.sheets[2], {80, 50}, {-1, 0}, 1.2);
    ASSERT_LT(inwards_of(brep).least_opening, 0);
    const PlanCurves curves = test::curves_of(model, brep);
    open_body_ends(brep.horizons, model, brep.cells, curves);
    EXPECT_GT(inwards_of(brep).least_opening, 2e-4);
    EXPECT_GT(inwards_of(brep).least_open, 0);
}

}  // namespace
}  // namespace stratareeb
