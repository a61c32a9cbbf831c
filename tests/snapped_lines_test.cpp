// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/snapped_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "subdivision/horizon_sheets.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::grid_model;

constexpr double kSize = 150;

HeightPatch patch(const std::function<double(double)>& z_of_x) {
    HeightPatch sheet{CubicKnots::uniform(-10, 110, 12), CubicKnots::uniform(-10, 110, 12), {}};
    const auto along_x = interpolate_spline(sheet.x, z_of_x);
    for (std::size_t i = 0; i < sheet.x.functions(); ++i)
        for (std::size_t j = 0; j < sheet.y.functions(); ++j) sheet.coefficients.push_back(along_x[i]);
    return sheet;
}

// A layer that ends at x = 50 between two that go on, and sheets for it by hand: its base meets the sheet above at `meets`.
struct Wedge {
    LayerModel model = grid_model(
        {.cells = 20,
         .thickness = {test::constant(5), [](double x, double) { return x < 50 ? 0.1 * (50 - x) : 0; },
                       test::constant(5)}});
    PlanCells cells = build_plan_cells(model);
    PlanCurves curves = build_plan_curves(model.plan.surface, cells, 2e-5 * kSize);
    HorizonSheets sheets;

    explicit Wedge(double meets, double slope = 0.1) {
        sheets.gaps.assign(cells.bodies.size(), 0);
        const auto flat = [](double z) { return [z](double) { return z; }; };
        sheets.sheets = {patch(flat(0)), patch(flat(-5)),
                         patch([=](double x) { return -5 - slope * (meets - x); }), patch(flat(-20))};
        for (const auto& cell : cells.cells)
            sheets.of_cell.push_back(cell.body_above == PlanCells::kNone ? 0 : cell.body_above + 1);
    }

    LineMoves moves() const { return snapped_lines(model.plan.surface, cells, curves, sheets, kSize); }

    std::set<std::uint32_t> ends() const {
        std::set<std::uint32_t> result;
        for (const auto& line : cells.lines)
            if (line.side == PlanCells::kNone) result.insert({line.vertices.front(), line.vertices.back()});
        return result;
    }
};

TEST(SnappedLines, run_where_the_sheets_meet) {
    for (const double meets : {49.2, 49.9, 50.0, 50.3, 50.9}) {
        const Wedge wedge(meets);
        const LineMoves moves = wedge.moves();
        const auto ends = wedge.ends();
        ASSERT_EQ(ends.size(), 2u);
        ASSERT_GE(moves.inner.size(), 15u);
        std::size_t exact = 0;
        for (const auto& [v, p] : moves.inner) {
            EXPECT_FALSE(ends.contains(v));
            exact += std::abs(p.x - meets) < 1e-3;
        }
        EXPECT_GE(exact, 12u) << "all but the few beside the ends, at " << meets;
        ASSERT_FALSE(moves.on_side.empty());
        for (const auto& [key, length] : moves.on_side) {
            const auto& side = wedge.cells.sides[key.first].vertices;
            const auto& from =
                wedge.model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(side[0])));
            EXPECT_NEAR(length, std::abs(meets - from[0]), 1e-3) << "the end on the rim moves along it";
        }
    }
}

TEST(SnappedLines, move_by_a_quarter_of_their_edges_at_most) {
    for (const double meets : {30.0, 46.0, 54.0, 80.0}) {
        const Wedge wedge(meets);
        for (const auto& [v, p] : wedge.moves().inner) {
            const auto& from = wedge.model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
            EXPECT_LE(std::hypot(p.x - from[0], p.y - from[1]), 0.25 * 5 + 1e-9);
            EXPECT_NEAR(p.y, from[1], 1e-9) << "across the line only";
        }
    }
}

// Where sheets part by next to nothing a line has no reason to move far.
TEST(SnappedLines, stay_where_sheets_hardly_part) {
    const Wedge wedge(50.9, 1e-9);
    for (const auto& [v, p] : wedge.moves().inner) {
        const auto& from = wedge.model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
        EXPECT_NEAR(p.x, from[0], 1e-3);
    }
}

}  // namespace
}  // namespace stratareeb
