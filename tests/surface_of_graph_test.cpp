// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_of_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "reeb/cut_crossings.h"
#include "reeb/graph_conditions.h"

namespace stratareeb {
namespace {

//! Built by hand, a line each.
struct Draft {
    EnhancedReebGraph graph;

    std::uint32_t node(double z, NodeForm form) {
        EnhancedNode& node = graph.nodes.emplace_back();
        node.id = static_cast<std::int64_t>(graph.nodes.size());
        node.position = {0, 0, z};
        node.form = form;
        return static_cast<std::uint32_t>(graph.nodes.size() - 1);
    }
    //! A square about (x, 0), by half its side.
    std::uint32_t square(double x, double half, double z) {
        EnhancedContour& contour = graph.contours.emplace_back();
        contour.id = static_cast<std::int64_t>(graph.contours.size());
        contour.curve.closed = true;
        contour.curve.points = {
            {x - half, -half, z}, {x + half, -half, z}, {x + half, half, z}, {x - half, half, z}};
        return static_cast<std::uint32_t>(graph.contours.size() - 1);
    }
    void edge(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t> contours) {
        EnhancedEdge& edge = graph.edges.emplace_back();
        edge.from = from;
        edge.to = to;
        edge.contours = std::move(contours);
        edge.homotopy.kind = HomotopyKind::Linear;
    }
};

MeshReport report_of(const EnhancedReebGraph& graph) {
    const auto faults = faults_of(graph);
    EXPECT_TRUE(faults.empty()) << (faults.empty() ? "" : faults.front());
    return analyze(surface_of_graph(graph).soup);
}

//! Floor and ceiling with a square hole through both.
Draft pierced_plate(std::uint32_t holes) {
    Draft draft;
    const auto floor = draft.node(0, NodeForm::Flat), ceiling = draft.node(2, NodeForm::Flat);
    draft.edge(floor, ceiling, {draft.square(0, 10, 0), draft.square(0, 10, 2)});
    for (std::uint32_t k = 0; k < holes; ++k)
        draft.edge(floor, ceiling, {draft.square(3.0 * k - 6, 1, 0), draft.square(3.0 * k - 6, 1, 2)});
    return draft;
}

TEST(SurfaceOfGraph, floors_and_ceilings_have_holes) {
    for (const std::uint32_t holes : {0u, 1u, 2u, 5u}) {
        const MeshReport report = report_of(pierced_plate(holes).graph);
        EXPECT_TRUE(report.watertight) << holes;
        EXPECT_EQ(report.genus, holes);
        EXPECT_NEAR(report.volume, 2 * (400 - 4.0 * holes), 1e-3);
    }
}

TEST(SurfaceOfGraph, steps_and_shelves_are_level) {
    Draft draft;  // three storeys; then two towers
    const auto ground = draft.node(0, NodeForm::Flat), first = draft.node(1, NodeForm::Flat),
               second = draft.node(2, NodeForm::Flat), left = draft.node(4, NodeForm::Flat),
               right = draft.node(3, NodeForm::Flat);
    draft.edge(ground, first, {draft.square(0, 3, 0), draft.square(0, 3, 1)});
    draft.edge(first, second, {draft.square(0, 5, 1), draft.square(0, 5, 2)});
    draft.edge(second, left, {draft.square(-3, 1, 2), draft.square(-3, 1, 4)});
    draft.edge(second, right, {draft.square(3, 1.5, 2), draft.square(3, 1.5, 3)});
    const MeshReport report = report_of(draft.graph);
    EXPECT_TRUE(report.watertight) << (report.problems.empty() ? "" : report.problems.front());
    EXPECT_EQ(report.components, 1u);
    EXPECT_NEAR(report.volume, 36 + 100 + 8 + 9, 1e-3);
}

TEST(SurfaceOfGraph, open_ends_stay_open) {
    Draft draft;
    const auto low = draft.node(0, NodeForm::Open), high = draft.node(3, NodeForm::Open);
    draft.edge(low, high, {draft.square(0, 2, 0), draft.square(0, 1, 3)});
    const MeshReport report = report_of(draft.graph);
    EXPECT_TRUE(report.manifold && report.oriented);
    EXPECT_EQ(report.boundary_loops, 2u);
    EXPECT_NEAR(report.area, 4 * (4 + 2) / 2.0 * std::sqrt(10.0), 1e-2);
}

TEST(SurfaceOfGraph, faults_at_level_nodes_are_named) {
    const auto has = [](const Draft& draft, const char* text) {
        for (const std::string& fault : faults_of(draft.graph))
            if (fault.find(text) != std::string::npos) return true;
        return false;
    };
    Draft off = pierced_plate(1);
    off.graph.nodes[1].position.z = 2.5;
    EXPECT_TRUE(has(off, "has to stand at its height"));
    Draft crossing = pierced_plate(0);
    crossing.edge(0, 1, {crossing.square(10, 1, 0), crossing.square(10, 1, 2)});
    EXPECT_TRUE(has(crossing, "its contours cross"));
    Draft open = pierced_plate(1);
    open.graph.nodes[0].form = NodeForm::Open;
    EXPECT_TRUE(has(open, "an open end has one"));
}

TEST(CutCrossings, cuts_off_small_loops_and_leaves_large_ones) {
    const std::vector<Point3> knot{{0, 0, 0},      {10, 0, 0},    {10, 10, 0}, {5.1, 10, 0},
                                   {5.3, 10.2, 0}, {5.3, 9.8, 0}, {5, 10, 0},  {0, 10, 0}};
    std::vector<Point3> mended = knot;
    EXPECT_TRUE(cut_crossings(mended, 0.05));
    EXPECT_LT(mended.size(), knot.size());
    std::vector<Point3> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto before = bow;
    EXPECT_FALSE(cut_crossings(bow, 0.05));
    EXPECT_EQ(bow, before);
}

}  // namespace
}  // namespace stratareeb
