// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/body_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "subdivision/smooth_brep.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::grid_model;

constexpr double kGap = 1e-3;

double lens(double x, double y) {
    const double r = std::hypot(x - 50, y - 50) / 30;
    return r < 1 - 1e-9 ? 6 * (1 - r * r) : 0;
}

LayerModel lens_model() {
    return grid_model({.cells = 40,
                       .ground = [](double x, double y) { return 3 * std::sin(x / 13) * std::cos(y / 11); },
                       .thickness = {test::constant(4), lens, test::constant(4)},
                       .rounds = {{50, 50, 30}}});
}

// The least and the largest height of sheet 1 (the lens's top) above sheet 2 (its base) along the lines where the lens ends.
std::pair<double, double> gaps_at_ends(const SmoothBrep& brep) {
    double least = INFINITY, most = -INFINITY;
    const auto ends = body_ends(brep.cells, brep.horizons.of_cell);
    for (const BodyEnd& end : ends[1]) {
        const SplineCurve& curve = brep.edges[end.edge].curve;
        const auto& breaks = curve.knots.breaks();
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            for (double k = 0.05; k < 1; k += 0.1) {
                const double t = std::lerp(breaks[s], breaks[s + 1], k);
                const Point2 p{curve.at(0, t), curve.at(1, t)};
                const double gap = brep.horizons.sheets[1].z(p) - brep.horizons.sheets[2].z(p);
                least = std::min(least, gap), most = std::max(most, gap);
            }
    }
    return {least, most};
}

TEST(BodyEnds, are_the_edges_around_a_lens) {
    const auto model = lens_model();
    const auto cells = build_plan_cells(model);
    std::vector<std::uint32_t> of_cell;
    for (const auto& cell : cells.cells)
        of_cell.push_back(cell.body_above == PlanCells::kNone ? 0 : cell.body_above + 1);
    const auto ends = body_ends(cells, of_cell);
    ASSERT_EQ(ends.size(), 3u);
    EXPECT_TRUE(ends[0].empty());
    EXPECT_TRUE(ends[2].empty());
    double around = 0;
    for (const BodyEnd& end : ends[1]) {
        EXPECT_EQ(end.above, 1u);
        const auto& vertices = cells.lines[cells.edges[end.edge].line].vertices;
        const auto at = [&](std::size_t i) {
            return model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(vertices[i])));
        };
        for (std::size_t i = 1; i < vertices.size(); ++i) around += (at(i) - at(i - 1)).norm();
    }
    EXPECT_NEAR(around, 2 * std::numbers::pi * 30, 0.15 * 2 * std::numbers::pi * 30);  // it zigzags
}

// Two layers that end along the same line: each below the one above, in order.
TEST(BodyEnds, of_layers_that_end_together_are_in_order) {
    const auto model =
        grid_model({.cells = 40,
                    .ground = [](double x, double y) { return 3 * std::sin(x / 13) * std::cos(y / 11); },
                    .thickness = {test::constant(4), lens, [](double x, double y) { return lens(x, y) / 2; },
                                  test::constant(4)},
                    .rounds = {{50, 50, 30}}});
    const SmoothBrep brep = build_smooth_brep(model, {.sheets = {.end_gap = 1e-6}});
    const auto ends = body_ends(brep.cells, brep.horizons.of_cell);
    ASSERT_EQ(ends.size(), 4u);
    for (const BodyEnd& end : ends[1]) EXPECT_EQ(end.above, 1u);
    ASSERT_FALSE(ends[2].empty());
    for (const BodyEnd& end : ends[2]) {
        EXPECT_EQ(end.above, 2u);
        const SplineCurve& curve = brep.edges[end.edge].curve;
        for (double k = 0; k <= 1; k += 0.01) {
            const double t = std::lerp(curve.knots.low(), curve.knots.high(), k);
            const Point2 p{curve.at(0, t), curve.at(1, t)};
            EXPECT_GT(brep.horizons.sheets[1].z(p), brep.horizons.sheets[2].z(p));
            EXPECT_GT(brep.horizons.sheets[2].z(p), brep.horizons.sheets[3].z(p));
        }
    }
}

// The section of two sheets must not lie inside a body: there programs would find a new edge.
TEST(BodyEnds, top_and_base_of_a_lens_stay_apart_by_a_hair_along_its_edge) {
    const SmoothBrep brep = build_smooth_brep(lens_model(), {.sheets = {.end_gap = 1e-6}});
    const double gap = 1e-6 * brep.size;
    const auto [least, most] = gaps_at_ends(brep);
    EXPECT_GT(least, 0.25 * gap);
    EXPECT_LT(most, 100 * gap);  // the outline zigzags by more than it may be moved
    EXPECT_GT(brep.horizons.least_thickness[1], 0);
}

TEST(BodyEnds, are_opened_where_a_base_came_through_its_top_and_nowhere_else) {
    const auto model = lens_model();
    SmoothBrep brep = build_smooth_brep(model, {.sheets = {.end_gap = 1e-6}});
    const Point2 at_edge{80, 50}, inside{50, 50};
    lower_at(brep.horizons.sheets[2], at_edge, -0.1);
    ASSERT_LT(gaps_at_ends(brep).first, -0.05);
    const double before = brep.horizons.sheets[2].z(inside);
    PlanCurves curves = build_plan_curves(model.plan.surface, brep.cells, 2e-5 * brep.size);
    for (std::size_t e = 0; e < brep.edges.size(); ++e)
        if (const auto line = brep.cells.edges[e].line; line != PlanCells::kNone)
            curves.lines[line].curve = {
                brep.edges[e].curve.knots,
                {brep.edges[e].curve.coefficients[0], brep.edges[e].curve.coefficients[1]}};
    brep.horizons.gaps.assign(brep.cells.bodies.size(), kGap);
    open_body_ends(brep.horizons, model, brep.cells, curves);
    EXPECT_GT(gaps_at_ends(brep).first, 0.25 * kGap);
    EXPECT_LT(gaps_at_ends(brep).second, 0.2);
    EXPECT_EQ(brep.horizons.sheets[2].z(inside), before);
}

}  // namespace
}  // namespace stratareeb
