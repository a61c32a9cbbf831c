// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/simplify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "boreholes/errors.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/persistence.h"
#include "tests/graph_cases.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using testing::GraphCase;

double range_of(const ReebGraph& graph) {
    return graph.nodes.empty() ? 0 : graph.nodes.back().value - graph.nodes.front().value;
}

double random_share(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>(0, random() % 4 ? 0.5 : 1)(random);
}

//! Kind and the vertices of both nodes.
using NamedPair = std::tuple<PairKind, std::uint32_t, std::uint32_t>;

std::vector<NamedPair> pairs_of_at_least(const ReebGraph& graph, double threshold) {
    std::vector<NamedPair> result;
    for (const auto& pair : persistence_pairs(graph))
        if (pair.kind == PairKind::Component || pair.persistence >= threshold)
            result.emplace_back(pair.kind, graph.nodes[pair.lower].vertex, graph.nodes[pair.upper].vertex);
    std::ranges::sort(result);
    return result;
}

std::size_t count_below(const ReebGraph& graph, double threshold, bool loops) {
    std::size_t count = 0;
    for (const auto& pair : persistence_pairs(graph))
        count += pair.kind != PairKind::Component && pair.persistence < threshold &&
                 (pair.kind == PairKind::Loop) == loops;
    return count;
}

CriticalType type_by_degrees(const ReebNode& node) {
    if (node.down == 0) return CriticalType::Minimum;
    return node.up == 0 ? CriticalType::Maximum : CriticalType::Saddle;
}

void expect_valid(const ReebGraph& graph, const ScalarField& field) {
    std::vector<std::uint32_t> down(graph.nodes.size()), up(graph.nodes.size());
    for (const ReebArc& arc : graph.arcs) {
        ASSERT_LT(arc.lower, arc.upper);
        ASSERT_LT(arc.upper, graph.nodes.size());
        ++up[arc.lower];
        ++down[arc.upper];
    }
    EXPECT_TRUE(std::ranges::is_sorted(graph.arcs, {}, &ReebArc::lower));
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        const ReebNode& node = graph.nodes[n];
        EXPECT_EQ(node.down, down[n]);
        EXPECT_EQ(node.up, up[n]);
        EXPECT_FALSE(node.down == 1 && node.up == 1);
        EXPECT_EQ(node.type, type_by_degrees(node));
        EXPECT_EQ(node.value, field[node.vertex]);
        if (n > 0) {
            EXPECT_TRUE(is_below(field, graph.nodes[n - 1].vertex, node.vertex));
        }
    }
    EXPECT_EQ(graph.components, testing::count_components(graph));
}

double distance_to_range(const ReebGraph& graph, std::uint32_t a, double value) {
    const double low = graph.nodes[graph.arcs[a].lower].value, high = graph.nodes[graph.arcs[a].upper].value;
    return std::max({0.0, low - value, value - high});
}

double farthest_from_its_arc(const ReebGraph& graph, const ScalarField& field) {
    double farthest = 0;
    for (std::uint32_t v = 0; v < field.size(); ++v)
        if (graph.vertex_arc[v] != ReebGraph::kNone)
            farthest = std::max(farthest, distance_to_range(graph, graph.vertex_arc[v], field[v]));
    return farthest;
}

//! What holds for every graph.
SimplifiedGraph checked(const GraphCase& given, double share) {
    SimplifiedGraph result = simplify(given.graph, given.field, share);
    expect_valid(result.graph, given.field);
    EXPECT_EQ(result.threshold, share * range_of(given.graph));
    EXPECT_EQ(result.graph.components, given.graph.components);
    EXPECT_EQ(result.graph.hidden_loops, given.graph.hidden_loops);
    EXPECT_EQ(result.graph.loops() + result.closed_loops, given.graph.loops());
    EXPECT_EQ(count_below(result.graph, result.threshold, false), 0u);
    EXPECT_EQ(count_below(result.graph, result.threshold, true), 0u);
    for (std::size_t v = 0; v < given.field.size(); ++v) {
        const std::uint32_t arc = result.graph.vertex_arc[v];
        EXPECT_TRUE(arc < result.graph.arcs.size() || given.graph.vertex_arc[v] == ReebGraph::kNone);
    }
    return result;
}

//! The pairs of the result are the old ones that reach the threshold.
void expect_exact(const GraphCase& given, const SimplifiedGraph& result) {
    EXPECT_EQ(pairs_of_at_least(result.graph, 0), pairs_of_at_least(given.graph, result.threshold));
    EXPECT_EQ(result.pruned_branches, count_below(given.graph, result.threshold, false));
    EXPECT_EQ(result.closed_loops, count_below(given.graph, result.threshold, true));
}

TEST(Simplify, of_forests_leaves_the_persistent_pairs_as_they_are) {
    std::mt19937_64 random(31);
    std::size_t pruned = 0;
    for (int round = 0; round < 20'000; ++round) {
        const GraphCase given = testing::random_forest(random, round % 20 ? 16 : 90);
        const SimplifiedGraph result = checked(given, random_share(random));
        expect_exact(given, result);
        EXPECT_LE(farthest_from_its_arc(result.graph, given.field), result.threshold);
        pruned += result.pruned_branches;
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    EXPECT_GT(pruned, 10'000u);
}

TEST(Simplify, of_any_graph_leaves_pairs_that_reach_the_threshold) {
    std::mt19937_64 random(32);
    std::size_t closed = 0;
    for (int round = 0; round < 20'000; ++round) {
        const GraphCase given = testing::random_case(random, round % 20 ? 16 : 90);
        closed += checked(given, random_share(random)).closed_loops;
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    EXPECT_GT(closed, 5000u);
}

TEST(Simplify, that_closes_no_loop_leaves_the_persistent_pairs_as_they_are) {
    std::mt19937_64 random(33);
    int compared = 0;
    for (int round = 0; round < 60'000 && compared < 3000; ++round) {
        const GraphCase given = testing::random_case(random, 20);
        const double share = random_share(random) * 0.5;
        if (given.graph.loops() == 0 || count_below(given.graph, share * range_of(given.graph), true) > 0)
            continue;
        expect_exact(given, checked(given, share));
        ASSERT_FALSE(HasFailure()) << "round " << round;
        ++compared;
    }
    EXPECT_EQ(compared, 3000);
}

//! Loops within loops, one after the other, and branches on them: all sides rise.
GraphCase nested_loops(std::mt19937_64& random) {
    struct Draft {
        double lower, upper;
    };
    std::uniform_real_distribution<double> share(0, 1);
    const auto between = [&](const Draft& arc, double from, double to) {
        return arc.lower + (arc.upper - arc.lower) * (from + (to - from) * share(random));
    };
    std::vector<Draft> drafts{{0, 1}};
    std::vector<double> heights{0, 1};
    for (auto count = 1 + random() % 8; count > 0; --count) {
        const std::size_t a = random() % drafts.size();
        const Draft arc = drafts[a];
        const double x = between(arc, 0, 0.5), y = between(arc, 0.5, 1);
        heights.push_back(x);
        if (random() % 2) {  // a loop
            heights.push_back(y);
            drafts[a] = {arc.lower, x};
            for (const Draft& added : {Draft{x, y}, Draft{x, y}, Draft{y, arc.upper}})
                drafts.push_back(added);
        } else {  // a branch up or down
            const double tip = random() % 2 ? x + share(random) : x - share(random);
            heights.push_back(tip);
            drafts[a] = {arc.lower, x};
            drafts.push_back({x, arc.upper});
            drafts.push_back({std::min(x, tip), std::max(x, tip)});
        }
    }
    std::ranges::sort(heights);
    const auto node = [&](double height) {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(heights, height) - heights.begin());
    };
    std::vector<testing::NodePair> arcs;
    for (const Draft& arc : drafts) arcs.emplace_back(node(arc.lower), node(arc.upper));
    return testing::graph_case(static_cast<std::uint32_t>(heights.size()), arcs, 20, 1000, random);
}

TEST(Simplify, that_closes_loops_with_rising_sides_leaves_the_persistent_pairs_as_they_are) {
    std::mt19937_64 random(34);
    std::size_t closed = 0;
    for (int round = 0; round < 10'000; ++round) {
        const GraphCase given = nested_loops(random);
        const SimplifiedGraph result = checked(given, random_share(random));
        expect_exact(given, result);
        EXPECT_LE(farthest_from_its_arc(result.graph, given.field), result.threshold);
        closed += result.closed_loops;
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    EXPECT_GT(closed, 5000u);
}

TEST(Simplify, by_nothing_changes_nothing) {
    std::mt19937_64 random(35);
    const TriMesh mesh = half_edge_mesh(shapes::plate_with_holes(2));
    for (int round = 0; round < 50; ++round) {
        ScalarField field(mesh.n_vertices());
        for (double& value : field) value = static_cast<double>(random() % 50);
        const ReebGraph graph = reeb_graph(mesh, field), same = simplify(graph, mesh, field, 0).graph;
        ASSERT_EQ(same.arcs.size(), graph.arcs.size());
        std::vector<testing::NodePair> before, after;
        for (const ReebArc& arc : graph.arcs) before.emplace_back(arc.lower, arc.upper);
        for (const ReebArc& arc : same.arcs) after.emplace_back(arc.lower, arc.upper);
        std::ranges::sort(before);
        std::ranges::sort(after);
        EXPECT_EQ(after, before);
        EXPECT_EQ(same.triangle_arc.size(), graph.triangle_arc.size());
        EXPECT_EQ(farthest_from_its_arc(same, field), 0);
    }
}

TEST(Simplify, of_reeb_graphs_of_surfaces) {
    std::mt19937_64 random(36);
    for (const auto& soup : {shapes::uv_sphere(1, 12, 16), shapes::torus(3, 1, 16, 8), shapes::double_torus(),
                             shapes::plate_with_holes(3), shapes::terrain(12), shapes::annulus(9, 1, 2)}) {
        const TriMesh mesh = half_edge_mesh(soup);
        for (int round = 0; round < 60; ++round) {
            GraphCase given;
            given.field = height_field(mesh, {1, 0.4, 0.3});
            for (double& value : given.field)
                value = round % 2 ? static_cast<double>(random() % 40)
                                  : value + static_cast<double>(random() % 9) / 20;
            given.graph = reeb_graph(mesh, given.field);
            if (round % 4 == 1) given.graph = collapse_plateaus(given.graph);
            const double share = random_share(random);
            const SimplifiedGraph result = checked(given, share);
            const ReebGraph with_triangles = simplify(given.graph, mesh, given.field, share).graph;
            EXPECT_EQ(with_triangles.vertex_arc, result.graph.vertex_arc);
            ASSERT_EQ(with_triangles.triangle_arc.size(), mesh.n_faces());
            for (const std::uint32_t arc : with_triangles.triangle_arc)
                ASSERT_LT(arc, with_triangles.arcs.size());
            ASSERT_FALSE(HasFailure()) << "round " << round;
        }
    }
}

// A triangle between nodes lies where its middle vertex does; so it does after arcs are glued.
TEST(Simplify, keeps_triangles_with_their_middle_vertices) {
    std::mt19937_64 random(37);
    const TriMesh mesh = half_edge_mesh(shapes::torus(3, 1, 16, 8));
    for (int round = 0; round < 100; ++round) {
        ScalarField field(mesh.n_vertices());
        for (double& value : field) value = static_cast<double>(random() % 1'000'000);
        const ReebGraph graph = reeb_graph(mesh, field), simple = simplify(graph, mesh, field, 0.4).graph;
        std::vector<char> is_node(field.size(), 0);
        for (const auto& node : graph.nodes) is_node[node.vertex] = 1;
        for (const auto face : mesh.faces()) {
            std::vector<std::uint32_t> corners;
            for (const auto v : mesh.fv_range(face)) corners.push_back(static_cast<std::uint32_t>(v.idx()));
            std::ranges::sort(corners, {}, [&](std::uint32_t v) { return field[v]; });
            if (is_node[corners[1]]) continue;
            EXPECT_EQ(simple.triangle_arc[static_cast<std::size_t>(face.idx())],
                      simple.vertex_arc[corners[1]]);
        }
    }
}

// A pit that a bump has grown in: when the pit goes, the bump moves over to what the pit was in, at its height.
TEST(Simplify, moves_what_grew_on_a_branch_over_to_its_trunk) {
    GraphCase given;
    const std::vector<double> values{0, 4, 5, 6, 9, 10};  // deep end, pit, bump's foot, pit's rim, bump, top
    for (std::uint32_t n = 0; n < 6; ++n)
        given.graph.nodes.push_back({n, values[n], CriticalType::Saddle, 0, 0});
    for (const auto& [lower, upper] : std::vector<testing::NodePair>{{0, 3}, {1, 2}, {2, 3}, {2, 4}, {3, 5}})
        given.graph.arcs.push_back({lower, upper});
    testing::complete(given.graph);
    given.field = {0, 4, 5, 6, 9, 10, 5.5, 4.5, 2};
    given.graph.vertex_arc = {0, 1, 2, 4, 3, 4, 0, 1, 0};
    const SimplifiedGraph result = simplify(given.graph, given.field, 0.25);
    expect_valid(result.graph, given.field);
    expect_exact(given, result);
    ASSERT_EQ(result.graph.nodes.size(), 4u);
    EXPECT_EQ(result.graph.nodes[1].vertex, 2u);
    EXPECT_EQ(result.pruned_branches, 1u);
    const auto& arcs = result.graph.arcs;
    EXPECT_EQ(arcs[result.graph.vertex_arc[6]].upper, 3u);  // 5.5 on the trunk, now above the bump's foot
    EXPECT_EQ(arcs[result.graph.vertex_arc[8]].upper, 1u);  // 2, below it
}

TEST(Simplify, refuses_what_makes_no_sense) {
    const TriMesh mesh = half_edge_mesh(shapes::cube());
    const ScalarField field = height_field(mesh);
    const ReebGraph graph = reeb_graph(mesh, field);
    for (const double share : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(simplify(graph, field, share), InvalidInput);
    EXPECT_THROW(simplify(graph, ScalarField(2), 0.1), InvalidInput);
    EXPECT_TRUE(simplify(ReebGraph(), {}, 0.5).graph.nodes.empty());
}

}  // namespace
}  // namespace stratareeb
