// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/followed_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "subdivision/sheet_gaps.h"
#include "subdivision/spline_fit.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

// A level sheet at 0 and one whose height is the distance to a wave about y = 50, times a slope, less the gap: they are the
// gap apart on the wave.
struct Crossing {
    LayerModel model;
    PlanCells cells;
    PlanCurves curves;
    HorizonSheets sheets;
};

constexpr double kSlope = 0.3, kSize = 150, kGap = 1e-6 * kSize;

double wave(double x) {
    return 50 + 0.4 * std::sin(x / 4);
}

HeightPatch patch(const std::function<double(double, double)>& height) {
    HeightPatch p{CubicKnots::uniform(-5, 105, 60), CubicKnots::uniform(-5, 105, 10), {}};
    for (const double y : p.y.greville()) {
        const auto row = interpolate_spline(p.x, [&](double x) { return height(x, y); });
        p.coefficients.insert(p.coefficients.end(), row.begin(), row.end());
    }
    // Rows are of y so far.
    std::vector<double> by_x;
    const std::size_t nx = p.x.functions(), ny = p.y.functions();
    for (std::size_t i = 0; i < nx; ++i)
        for (std::size_t j = 0; j < ny; ++j) by_x.push_back(p.coefficients[j * nx + i]);
    p.coefficients = std::move(by_x);
    return p;
}

Crossing crossing() {
    Crossing c{.model = test::grid_model(
                   {.cells = 25,
                    .thickness = {test::constant(4),
                                  [](double, double y) { return std::max(0.0, kSlope * (y - 48)); },
                                  test::constant(4)}})};
    c.cells = build_plan_cells(c.model);
    c.curves = build_plan_curves(c.model.plan.surface, c.cells, 2e-5 * kSize);
    for (const auto& cell : c.cells.cells)
        c.sheets.of_cell.push_back(cell.body_above == PlanCells::kNone ? 0 : cell.body_above + 1);
    c.sheets.sheets = {patch([](double, double) { return 4; }), patch([](double, double) { return 0; }),
                       patch([](double x, double y) { return kSlope * (wave(x) - y) + kSlope * -2; }),
                       patch([](double, double) { return -60; })};
    c.sheets.gaps.assign(c.cells.bodies.size(), kGap);
    return c;
}

TEST(FollowedLines, run_where_sheets_are_the_gap_apart) {
    const auto c = crossing();
    const auto lines = followed_lines(c.cells, c.curves, c.sheets, kSize);
    std::size_t inner = 0;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const auto& before = c.curves.lines[l].curve;
        for (const double t : {before.knots.low(), before.knots.high()})
            for (const std::size_t k : {0, 1}) EXPECT_NEAR(lines[l].at(k, t), before.at(k, t), 1e-9);
        if (c.cells.lines[l].side != PlanCells::kNone) continue;
        ++inner;
        const SheetGap gap{1, 2, kGap};
        double worst = 0, worst_before = 0;
        for (double x = 5; x < 95; x += 0.37) {
            const double t = std::lerp(before.knots.low(), before.knots.high(), x / 100);
            worst = std::max(worst, std::abs(off_gap(c.sheets, gap, {lines[l].at(0, t), lines[l].at(1, t)})));
            worst_before =
                std::max(worst_before, std::abs(off_gap(c.sheets, gap, {before.at(0, t), before.at(1, t)})));
        }
        EXPECT_LT(worst, kGap);
        EXPECT_GT(worst_before, 100 * kGap);
    }
    EXPECT_EQ(inner, 1u);
}

TEST(FollowedLines, do_not_go_further_than_a_quarter_of_an_edge) {
    auto c = crossing();
    c.sheets.sheets[2] = patch([](double, double y) { return kSlope * (70 - y); });
    for (const auto& line : followed_lines(c.cells, c.curves, c.sheets, kSize))
        for (const double y : line.coefficients[1])
            EXPECT_TRUE(y < 50 || y > 95 || line.coefficients[0][1] < 1 || line.coefficients[0][1] > 99) << y;
}

TEST(SheetGaps, closest_place_is_where_sheets_are_the_gap_apart_or_as_far_as_may_be) {
    const auto c = crossing();
    const SheetGaps gaps{{1, 2, kGap}};
    const Point2 q = closest_to_gaps(c.sheets, gaps, {30, 47.5}, {0, 1}, 2, kSize);
    EXPECT_EQ(q.x, 30);
    EXPECT_NEAR(off_gap(c.sheets, *gaps.begin(), q), 0, 1e-9);
    const Point2 far = closest_to_gaps(c.sheets, gaps, {30, 20}, {0, 1}, 2, kSize);
    EXPECT_NEAR(far.y, 22, 1e-6);
}

}  // namespace
}  // namespace stratareeb
