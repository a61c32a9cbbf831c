// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/body_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "subdivision/smooth_brep.h"
#include "tests/grid_model.h"
#include "tests/lens_model.h"

namespace stratareeb {
namespace {

using test::gaps_at_ends;
using test::grid_model;
using test::lens;
using test::lens_model;

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
    EXPECT_LT(most, 200 * gap);  // the outline zigzags by more than it may be moved
    EXPECT_GT(brep.horizons.least_thickness[1], 0);
}

}  // namespace
}  // namespace stratareeb
