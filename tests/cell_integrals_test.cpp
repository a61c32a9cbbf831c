// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cell_integrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "subdivision/strip_cells.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

constexpr double kPi = std::numbers::pi;

//! One face over a region in plan whose outline is given by curves, on a sheet given as a function.
template <typename Height>
SmoothBrep face_over(const std::vector<SplineCurve>& outline, const Height& height, std::size_t spans) {
    SmoothBrep brep;
    HeightPatch sheet{CubicKnots::uniform(-3, 4, spans), CubicKnots::uniform(-2, 5, spans + 3), {}};
    // Interpolated in both directions: rows of y first.
    const auto gx = sheet.x.greville(), gy = sheet.y.greville();
    std::vector<std::vector<double>> rows;
    for (const double y : gy)
        rows.push_back(interpolate_spline(sheet.x, [&](double x) { return height(x, y); }));
    for (std::size_t i = 0; i < gx.size(); ++i) {
        const auto column = interpolate_spline(sheet.y, [&](double y) {
            return rows[static_cast<std::size_t>(std::ranges::lower_bound(gy, y) - gy.begin())][i];
        });
        sheet.coefficients.insert(sheet.coefficients.end(), column.begin(), column.end());
    }
    brep.horizons.sheets = {sheet};
    brep.horizons.of_cell = {0};
    PlanCells::Cell cell;
    for (std::uint32_t e = 0; e < outline.size(); ++e) {
        brep.edges.push_back({.curve = outline[e]});
        brep.cells.edges.push_back({.line = e, .cells = {0}});
        cell.loops.push_back({{e, true}});
    }
    brep.cells.cells = {cell};
    return brep;
}

SplineCurve ellipse(double cx, double cy, double a, double b, std::size_t spans, double turn = 1) {
    const CubicKnots knots = CubicKnots::uniform(0, 2 * kPi, spans);
    return {knots,
            {interpolate_spline(knots, [&](double t) { return cx + a * std::cos(turn * t); }),
             interpolate_spline(knots, [&](double t) { return cy + b * std::sin(turn * t); })}};
}

double bowl(double x, double y) {
    return 2 + 0.3 * x * x - 0.2 * x * y + 0.1 * y * y * y;
}

TEST(CellIntegrals, of_a_cubic_over_an_ellipse_are_the_closed_forms) {
    const double a = 1.5, b = 0.8, cx = 0.3, cy = 1.1;
    const SmoothBrep brep = face_over({ellipse(cx, cy, a, b, 400)}, bowl, 7);
    const auto integrals = integrate_cell(brep, 0);
    const double area = kPi * a * b, xx = cx * cx + a * a / 4, yyy = cy * cy * cy + 3 * cy * b * b / 4;
    EXPECT_NEAR(integrals.area, area, 1e-8);
    EXPECT_NEAR(integrals.volume, area * (2 + 0.3 * xx - 0.2 * cx * cy + 0.1 * yyy), 1e-8);
}

TEST(CellIntegrals, leave_out_holes) {
    const SmoothBrep with_hole =
        face_over({ellipse(0, 1, 2, 1.5, 300), ellipse(0.2, 1.2, 0.5, 0.4, 300, -1)}, bowl, 9);
    const SmoothBrep whole = face_over({ellipse(0, 1, 2, 1.5, 300)}, bowl, 9),
                     hole = face_over({ellipse(0.2, 1.2, 0.5, 0.4, 300)}, bowl, 9);
    const Point3 from{7, -3, 2};
    const auto all = integrate_cell(whole, 0, from), out = integrate_cell(hole, 0, from),
               rest = integrate_cell(with_hole, 0, from);
    EXPECT_NEAR(rest.area, all.area - out.area, 1e-8);
    EXPECT_NEAR(rest.volume, all.volume - out.volume, 1e-8);
    EXPECT_NEAR(rest.from_point.cone, all.from_point.cone - out.from_point.cone, 1e-8);
}

TEST(CellIntegrals, cone_changes_with_the_point_as_normals_say) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> any(-9, 9);
    const SmoothBrep brep = face_over({ellipse(0, 1, 2, 1.5, 100)}, bowl, 9);
    for (int round = 0; round < 20; ++round) {
        const Point3 from{any(random), any(random), any(random)}, by{any(random), any(random), any(random)};
        const auto here = integrate_cell(brep, 0, from),
                   there = integrate_cell(brep, 0, {from.x + by.x, from.y + by.y, from.z + by.z});
        EXPECT_NEAR(there.from_point.cone, here.from_point.cone + here.from_point.growth(by), 1e-9);
        EXPECT_EQ(here.from_point.normal.z, here.area);
    }
}

// By brute force: (p - from) . n / 3 over small squares of the unit disk.
TEST(CellIntegrals, cone_is_the_flux_from_the_point) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-4, 4);
    const auto wave = [](double x, double y) { return std::sin(1.7 * x) * std::cos(y) + 0.2 * x; };
    const SmoothBrep brep = face_over({ellipse(0, 1, 1, 1, 300)}, wave, 60);
    const HeightPatch& sheet = brep.horizons.sheets[0];
    for (int round = 0; round < 5; ++round) {
        const Point3 from{any(random), any(random), any(random)};
        double flux = 0;
        const int n = 700;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double r = (i + 0.5) / n, angle = 2 * kPi * (j + 0.5) / n;
                const Point2 p{r * std::cos(angle), 1 + r * std::sin(angle)};
                const Point2 g = sheet.gradient(p);
                flux += r * (2 * kPi / n / n) / 3 *
                        (sheet.z(p) - from.z - (p.x - from.x) * g.x - (p.y - from.y) * g.y);
            }
        EXPECT_NEAR(integrate_cell(brep, 0, from).from_point.cone, flux, 2e-5);
    }
}

// Cut faces hold what the whole ones did, and bodies have the volume of their layers.
TEST(CellIntegrals, of_bodies_stay_when_their_faces_are_cut) {
    SmoothBrep brep = build_smooth_brep(
        test::grid_model({.cells = 30,
                          .ground = [](double x, double y) { return 3 * std::sin(x / 5) * std::cos(y / 4); },
                          .thickness = {test::constant(5), [](double x, double) { return 2 + 0.02 * x; }}}));
    ASSERT_EQ(brep.cells.bodies.size(), 2u);
    EXPECT_NEAR(body_volume(brep, brep.cells.bodies[0]), 5e4, 5e4 * 2e-4);
    EXPECT_NEAR(body_volume(brep, brep.cells.bodies[1]), 3e4, 3e4 * 2e-4);
    const double before[] = {body_volume(brep, brep.cells.bodies[0]),
                             body_volume(brep, brep.cells.bodies[1])};
    for (int round = 0; round < 2; ++round) {
        ASSERT_GT(halve_cells(brep, std::vector<char>(brep.cells.cells.size(), 1)), 0u);
        for (std::size_t b = 0; b < 2; ++b)
            EXPECT_NEAR(body_volume(brep, brep.cells.bodies[b]), before[b], 1e-8 * before[b]);
    }
}

}  // namespace
}  // namespace stratareeb
