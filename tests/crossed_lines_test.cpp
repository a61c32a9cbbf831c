// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/crossed_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "subdivision/smooth_brep.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

constexpr double kTolerance = 2e-5 * 150;

// Lenses that touch the rim, lie apart and lie in one another's reach.
LayerModel lenses() {
    const auto lens = [](double cx, double cy, double radius) {
        return [=](double x, double y) {
            const double r = std::hypot(x - cx, y - cy) / radius;
            return r < 1 - 1e-9 ? 4 * (1 - r * r) : 0;
        };
    };
    return test::grid_model(
        {.cells = 24,
         .thickness = {test::constant(5), lens(40, 45, 22), test::constant(3), lens(70, 60, 18)},
         .rounds = {{40, 45, 22}, {70, 60, 18}}});
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool near(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y) < 1e-9;
}

// Every pair of pieces of every cell's outline, forty a span.
std::set<std::uint32_t> crossed_by_force(const PlanCells& cells, const PlanCurves& curves) {
    struct Piece {
        Point2 a, b;
        std::uint32_t line;
    };
    std::set<std::uint32_t> found;
    for (const auto& cell : cells.cells) {
        std::vector<Piece> pieces;
        for (const auto& loop : cell.loops)
            for (const auto& use : loop) {
                const std::uint32_t line = cells.edges[use.edge].line;
                const SplineCurve& curve = curves.lines[line].curve;
                const std::size_t n = 40 * curve.knots.spans();
                const auto at = [&](std::size_t i) {
                    const double t = std::lerp(curve.knots.low(), curve.knots.high(),
                                               static_cast<double>(i) / static_cast<double>(n));
                    return Point2{curve.at(0, t), curve.at(1, t)};
                };
                for (std::size_t i = 0; i < n; ++i) pieces.push_back({at(i), at(i + 1), line});
            }
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (std::size_t j = i + 1; j < pieces.size(); ++j) {
                const Piece &p = pieces[i], &q = pieces[j];
                if (near(p.a, q.b) || near(p.b, q.a) || near(p.a, q.a) || near(p.b, q.b)) continue;
                if (turn(p.a, p.b, q.a) * turn(p.a, p.b, q.b) < 0 &&
                    turn(q.a, q.b, p.a) * turn(q.a, q.b, p.b) < 0)
                    for (const auto line : {p.line, q.line})
                        if (cells.lines[line].side == PlanCells::kNone) found.insert(line);
            }
    }
    return found;
}

TEST(CrossedLines, none_in_a_plan) {
    const LayerModel model = lenses();
    const PlanCells cells = build_plan_cells(model);
    EXPECT_TRUE(crossed_lines(cells, build_plan_curves(model.plan.surface, cells, kTolerance)).empty());
}

// Vertices thrown about: the lines that cross are those that all pairs of pieces say.
TEST(CrossedLines, are_those_that_brute_force_finds) {
    const LayerModel model = lenses();
    const PlanCells cells = build_plan_cells(model);
    std::size_t some = 0, none = 0;
    for (unsigned seed = 1; seed <= 24; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> by(-1, 1);
        LineMoves moves;
        const double reach = seed % 2 == 0 ? 0.8 : 9;
        for (const auto& line : cells.lines)
            for (std::size_t i = 1; i + 1 < line.vertices.size(); ++i) {
                if (line.side != PlanCells::kNone || random() % 6 != 0) continue;
                const auto p =
                    model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(line.vertices[i])));
                moves.inner[line.vertices[i]] = {p[0] + reach * by(random), p[1] + reach * by(random)};
            }
        const PlanCurves curves = build_plan_curves(model.plan.surface, cells, kTolerance, moves);
        const auto found = crossed_lines(cells, curves);
        EXPECT_EQ(found, crossed_by_force(cells, curves)) << "seed " << seed;
        ++(found.empty() ? none : some);
    }
    EXPECT_GT(some, 5u);
    EXPECT_GT(none, 5u);
}

TEST(CrossedLines, a_line_drawn_more_closely_is_nearer_to_its_vertices) {
    const LayerModel model = lenses();
    const PlanCells cells = build_plan_cells(model);
    const auto off = [&](int closer) {
        LineMoves moves;
        for (std::uint32_t l = 0; l < cells.lines.size(); ++l) moves.closer[l] = closer;
        const PlanCurves curves = build_plan_curves(model.plan.surface, cells, 0.3, moves);
        double worst = 0;
        for (std::uint32_t l = 0; l < cells.lines.size(); ++l)
            for (std::size_t i = 0; i < cells.lines[l].vertices.size(); ++i) {
                if (cells.lines[l].side != PlanCells::kNone) continue;
                const auto p = model.plan.surface.point(
                    TriMesh::VertexHandle(static_cast<int>(cells.lines[l].vertices[i])));
                const auto& curve = curves.lines[l];
                worst = std::max(worst, std::hypot(curve.curve.at(0, curve.parameters[i]) - p[0],
                                                   curve.curve.at(1, curve.parameters[i]) - p[1]));
            }
        return worst;
    };
    EXPECT_GT(off(0), 0.05);
    EXPECT_LE(off(1), 0.03);
    EXPECT_LE(off(2), 0.003);
}

}  // namespace
}  // namespace stratareeb
