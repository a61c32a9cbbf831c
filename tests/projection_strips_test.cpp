// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/projection_strips.h"

#include <gtest/gtest.h>

#include <cmath>

#include "subdivision/cell_integrals.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

// A thin layer that ends on a circle, over waves that need many spans.
SmoothBrep lens_over_waves() {
    const auto model = test::grid_model(
        {.cells = 40,
         .ground = [](double x, double y) { return 3 * std::sin(x / 5) * std::cos(y / 6); },
         .thickness = {[](double x, double y) { return std::max(0.0, 4 - std::hypot(x - 50, y - 50) / 8); },
                       test::constant(3)},
         .rounds = {{50, 50, 32}}});
    return build_smooth_brep(model, {.sheets = {.most_functions = 4000}});
}

std::size_t faces(const PlanCells::Body& body) {
    return body.top.size() + body.base.size() + body.walls.size();
}

TEST(ProjectionStrips, leave_faces_whole_whose_edges_are_close) {
    SmoothBrep brep = lens_over_waves();
    const std::size_t whole = brep.cells.cells.size();
    EXPECT_FALSE(cut_for_projection(brep, 10));
    EXPECT_EQ(brep.cells.cells.size(), whole);
}

TEST(ProjectionStrips, halve_faces_of_many_spans_with_edges_that_are_not) {
    SmoothBrep brep = lens_over_waves();
    const SmoothBrep whole = brep;
    for (auto& edge : brep.edges) edge.cad_spans = 8;
    ASSERT_TRUE(cut_for_projection(brep, 0));
    EXPECT_GT(brep.cells.cells.size(), whole.cells.cells.size());
    EXPECT_LE(brep.cells.cells.size(), 4 * whole.cells.cells.size()) << "each is halved twice at most";
    for (std::size_t b = 0; b < brep.cells.bodies.size(); ++b) {
        const double before = body_volume(whole, whole.cells.bodies[b]);
        EXPECT_NEAR(body_volume(brep, brep.cells.bodies[b]), before, 1e-8 * before);
    }
}

TEST(ProjectionStrips, stop_where_a_body_has_many_faces) {
    SmoothBrep brep = lens_over_waves();
    for (auto& edge : brep.edges) edge.cad_spans = 1;
    auto& body = brep.cells.bodies[0];
    const std::size_t walls = body.walls.size();
    body.walls.resize(49 - body.top.size() - body.base.size());  // as if it had that many
    cut_for_projection(brep, 0);
    EXPECT_EQ(faces(brep.cells.bodies[0]), 50u) << walls;
}

}  // namespace
}  // namespace stratareeb
