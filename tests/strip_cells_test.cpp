// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/strip_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "subdivision/smooth_brep.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::grid_model;

double wavy(double x, double y) {
    return 3 * std::sin(x / 5) * std::cos(y / 4);
}

// A lens between two layers, and another one that the rim cuts.
LayerModel lenses() {
    const auto lens = [](double cx, double cy, double radius) {
        return [=](double x, double y) {
            const double r = std::hypot(x - cx, y - cy) / radius;
            return r < 1 - 1e-9 ? 6 * (1 - r * r) : 0;
        };
    };
    return grid_model({.cells = 40,
                       .ground = wavy,
                       .thickness = {test::constant(5), lens(50, 50, 30), test::constant(5), lens(0, 30, 18)},
                       .rounds = {{50, 50, 30}, {0, 30, 18}}});
}

const SmoothBrep& uncut() {
    static const SmoothBrep brep = build_smooth_brep(lenses());
    return brep;
}

struct Span {
    double low, high;
};

std::uint32_t from_of(const PlanCells& cells, const PlanCells::EdgeUse& use) {
    return use.forward ? cells.edges[use.edge].from : cells.edges[use.edge].to;
}

std::uint32_t to_of(const PlanCells& cells, const PlanCells::EdgeUse& use) {
    return use.forward ? cells.edges[use.edge].to : cells.edges[use.edge].from;
}

// Area in plan by Green's theorem, with the same points on an edge for both of its sides.
double area_of(const SmoothBrep& brep, std::uint32_t cell) {
    double sum = 0;
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop) {
            const auto& curve = brep.edges[use.edge].curve;
            const int n = 2000;
            const double low = curve.knots.low(), high = curve.knots.high();
            for (int i = 0; i < n; ++i) {
                const double a = std::lerp(low, high, i / double(n)),
                             b = std::lerp(low, high, (i + 1) / double(n));
                const double part = (curve.at(0, a) * curve.at(1, b) - curve.at(0, b) * curve.at(1, a)) / 2;
                sum += use.forward ? part : -part;
            }
        }
    return sum;
}

Span span_of(const SmoothBrep& brep, std::uint32_t cell) {
    Span span{INFINITY, -INFINITY};
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop)
            for (const double x : brep.edges[use.edge].curve.coefficients[0])
                span = {std::min(span.low, x), std::max(span.high, x)};
    return span;
}

void expect_closed(const PlanCells& cells, const std::vector<PlanCells::Loop>& loops) {
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            ASSERT_EQ(to_of(cells, loop[i]), from_of(cells, loop[(i + 1) % loop.size()]));
}

// Every edge of a body is run through once in each direction by its faces: top as it is, base and walls the other way round.
void expect_closed_bodies(const PlanCells& cells) {
    for (const auto& body : cells.bodies) {
        std::map<std::uint32_t, int> balance, uses;
        const auto count = [&](const PlanCells::Loop& loop, bool turned) {
            for (const auto& use : loop) {
                balance[use.edge] += use.forward != turned ? 1 : -1;
                ++uses[use.edge];
            }
        };
        for (const auto c : body.top)
            for (const auto& loop : cells.cells[c].loops) count(loop, false);
        for (const auto c : body.base)
            for (const auto& loop : cells.cells[c].loops) count(loop, true);
        for (const auto& wall : body.walls) count(wall.loop, false);
        for (const auto& [edge, sum] : balance) {
            EXPECT_EQ(sum, 0) << "edge " << edge;
            EXPECT_EQ(uses[edge], 2) << "edge " << edge;
        }
    }
}

// Edges name just the faces whose loops they are in.
void expect_meeting_as_told(const PlanCells& cells) {
    std::vector<std::set<std::uint32_t>> meeting(cells.edges.size());
    for (std::uint32_t c = 0; c < cells.cells.size(); ++c)
        for (const auto& loop : cells.cells[c].loops)
            for (const auto& use : loop) meeting[use.edge].insert(c);
    for (std::size_t e = 0; e < cells.edges.size(); ++e) {
        if (cells.edges[e].line == PlanCells::kNone) continue;
        const auto& told = cells.edges[e].cells;
        EXPECT_EQ(std::set(told.begin(), told.end()), meeting[e]) << "edge " << e;
    }
}

double total(const SmoothBrep& brep, const std::vector<std::uint32_t>& list) {
    double sum = 0;
    for (const auto c : list) sum += area_of(brep, c);
    return sum;
}

// All faces halved so many times.
SmoothBrep halved(int times) {
    SmoothBrep brep = uncut();
    for (int i = 0; i < times; ++i) {
        const std::size_t before = brep.cells.cells.size();
        const std::size_t cut = halve_cells(brep, std::vector<char>(before, 1));
        EXPECT_GT(cut, 0u);
        EXPECT_GE(brep.cells.cells.size(), before + cut);  // a face with bays falls into more than two
    }
    return brep;
}

class StripCells : public ::testing::TestWithParam<int> {};

TEST_P(StripCells, cover_what_the_faces_covered_and_close_every_body) {
    std::vector<double> tops, bases;
    for (const auto& body : uncut().cells.bodies)
        tops.push_back(total(uncut(), body.top)), bases.push_back(total(uncut(), body.base));
    expect_closed_bodies(uncut().cells);
    expect_meeting_as_told(uncut().cells);
    const SmoothBrep brep = halved(GetParam());
    EXPECT_GT(brep.cells.cells.size(), uncut().cells.cells.size() + 3);
    ASSERT_EQ(brep.horizons.of_cell.size(), brep.cells.cells.size());
    ASSERT_EQ(brep.corners.size(), brep.cells.corners.size());
    ASSERT_EQ(brep.edges.size(), brep.cells.edges.size());
    for (std::size_t b = 0; b < brep.cells.bodies.size(); ++b) {
        EXPECT_NEAR(total(brep, brep.cells.bodies[b].top), tops[b], 1e-7 * tops[b]);
        EXPECT_NEAR(total(brep, brep.cells.bodies[b].base), bases[b], 1e-7 * bases[b]);
        EXPECT_NEAR(tops[b], bases[b], 1e-7 * tops[b]);
    }
    for (std::uint32_t c = 0; c < brep.cells.cells.size(); ++c) {
        expect_closed(brep.cells, brep.cells.cells[c].loops);
        EXPECT_GT(area_of(brep, c), 0) << "cell " << c;
    }
    for (const auto& body : brep.cells.bodies)
        for (const auto& wall : body.walls) expect_closed(brep.cells, {wall.loop});
    expect_closed_bodies(brep.cells);
}

TEST_P(StripCells, have_half_of_the_spans_and_their_edges_lie_in_the_sheets) {
    const SmoothBrep brep = halved(GetParam());
    std::size_t widest = 0;
    for (std::uint32_t c = 0; c < uncut().cells.cells.size(); ++c) {
        const Span span = span_of(uncut(), c);
        const CubicKnots& knots = uncut().sheet(c).x;
        widest = std::max(widest, knots.span(span.high) - knots.span(span.low) + 1);
    }
    for (std::uint32_t c = 0; c < brep.cells.cells.size(); ++c) {
        const Span span = span_of(brep, c);
        const CubicKnots& knots = brep.sheet(c).x;
        // A line gives way to corners by up to two spans.
        EXPECT_LE(knots.span(span.high) - knots.span(span.low) + 1, (widest >> GetParam()) + 5)
            << "cell " << c;
    }
    expect_meeting_as_told(brep.cells);
    for (std::size_t e = 0; e < brep.edges.size(); ++e) {
        const auto& edge = brep.cells.edges[e];
        if (edge.line == PlanCells::kNone) continue;
        const auto& curve = brep.edges[e].curve;
        const Point3 from = brep.corners[edge.from], to = brep.corners[edge.to];
        for (int i = 0; i <= 40; ++i) {
            const double t = std::lerp(curve.knots.low(), curve.knots.high(), i / 40.0);
            const Point2 p{curve.at(0, t), curve.at(1, t)};
            for (const auto c : edge.cells)
                EXPECT_NEAR(curve.at(2, t), brep.sheet(c).z(p), 2e-3 * brep.size) << "edge " << e;
            if (i == 0) {
                EXPECT_NEAR(std::hypot(p.x - from.x, p.y - from.y), 0, 1e-9);
            }
            if (i == 40) {
                EXPECT_NEAR(std::hypot(p.x - to.x, p.y - to.y), 0, 1e-9);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Times, StripCells, ::testing::Values(1, 2, 3));

TEST(StripCells, leave_faces_alone_that_are_not_named) {
    SmoothBrep brep = uncut();
    const std::size_t faces = brep.cells.cells.size(), edges = brep.edges.size();
    std::vector<char> which(faces, 0);
    EXPECT_EQ(halve_cells(brep, which), 0u);
    EXPECT_EQ(brep.cells.cells.size(), faces);
    EXPECT_EQ(brep.edges.size(), edges);
    which.front() = 1;
    EXPECT_EQ(halve_cells(brep, which), 1u);
    EXPECT_GT(brep.cells.cells.size(), faces);
    for (std::uint32_t c = 1; c < faces; ++c)
        EXPECT_NEAR(area_of(brep, c), area_of(uncut(), c), 1e-9 * area_of(uncut(), c));
    expect_closed_bodies(brep.cells);
}

// However often, in whatever order: narrow faces stay whole in the end.
TEST(StripCells, come_to_an_end) {
    SmoothBrep brep = uncut();
    std::size_t rounds = 0;
    while (halve_cells(brep, std::vector<char>(brep.cells.cells.size(), 1)) > 0) {
        expect_closed_bodies(brep.cells);
        ASSERT_LT(++rounds, 20u);
    }
    EXPECT_GT(rounds, 2u);
}

}  // namespace
}  // namespace stratareeb
