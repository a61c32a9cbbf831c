// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/persistence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tests/graph_cases.h"
#include "tests/persistence_oracle.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using testing::GraphCase;
using testing::PersistenceOracle;

using Triple = std::tuple<PairKind, std::uint32_t, std::uint32_t>;

std::vector<Triple> triples(const std::vector<PersistencePair>& pairs) {
    std::vector<Triple> result;
    for (const auto& pair : pairs) result.emplace_back(pair.kind, pair.lower, pair.upper);
    std::ranges::sort(result);
    return result;
}

GraphCase made(std::uint32_t nodes, const std::vector<testing::NodePair>& arcs) {
    std::mt19937_64 random(1);
    GraphCase result = testing::graph_case(nodes, arcs, 0, 1, random);
    for (std::uint32_t n = 0; n < nodes; ++n) result.graph.nodes[n].value = n;
    return result;
}

//! Reeb graphs of random fields on closed and open surfaces, with ties and without.
std::vector<ReebGraph> surface_graphs() {
    std::mt19937_64 random(23);
    std::vector<TriangleSoup> soups{
        shapes::uv_sphere(1, 5, 7),
        shapes::torus(3, 1, 7, 5),
        shapes::double_torus(),
        shapes::plate_with_holes(2),
        shapes::annulus(7, 1, 2),
        shapes::terrain(6),
        shapes::joined(shapes::uv_sphere(1, 4, 5), shapes::moved(shapes::torus(3, 1, 5, 4), 9, 0, 0))};
    std::vector<ReebGraph> graphs;
    for (const auto& soup : soups) {
        const TriMesh mesh = half_edge_mesh(soup);
        for (int round = 0; round < 60; ++round) {
            ScalarField field(mesh.n_vertices());
            for (double& value : field) value = static_cast<double>(random() % (round % 2 ? 9 : 1'000'000));
            graphs.push_back(reeb_graph(mesh, field));
        }
    }
    return graphs;
}

TEST(Persistence, agrees_with_matrix_reduction_on_thousands_of_random_graphs) {
    std::mt19937_64 random(21);
    std::map<PairKind, int> seen;
    for (int round = 0; round < 20'000; ++round) {
        const ReebGraph graph = testing::random_case(random, 4 + round % 16).graph;
        const auto found = triples(persistence_pairs(graph));
        ASSERT_EQ(found, PersistenceOracle(graph).pairs) << "round " << round;
        for (const auto& [kind, lower, upper] : found) ++seen[kind];
    }
    for (const auto& [kind, count] : seen) EXPECT_GT(count, 10'000);
    EXPECT_EQ(seen.size(), 4u);
}

TEST(Persistence, agrees_with_matrix_reduction_on_larger_random_graphs) {
    std::mt19937_64 random(22);
    for (int round = 0; round < 200; ++round) {
        const ReebGraph graph = testing::random_case(random, 80).graph;
        ASSERT_EQ(triples(persistence_pairs(graph)), PersistenceOracle(graph).pairs) << "round " << round;
    }
}

TEST(Persistence, agrees_with_matrix_reduction_on_reeb_graphs_of_surfaces) {
    for (const ReebGraph& graph : surface_graphs())
        ASSERT_EQ(triples(persistence_pairs(graph)), PersistenceOracle(graph).pairs);
}

TEST(Persistence, sorts_pairs_and_measures_them_by_values) {
    std::mt19937_64 random(24);
    for (int round = 0; round < 2000; ++round) {
        const ReebGraph graph = testing::random_case(random).graph;
        const auto pairs = persistence_pairs(graph);
        for (const auto& pair : pairs)
            EXPECT_EQ(pair.persistence, graph.nodes[pair.upper].value - graph.nodes[pair.lower].value);
        EXPECT_TRUE(std::ranges::is_sorted(
            pairs, {}, [](const auto& p) { return std::tuple(-p.persistence, p.lower, p.upper, p.kind); }));
    }
}

TEST(Persistence, uses_each_unit_of_a_node_once) {
    std::mt19937_64 random(25);
    for (int round = 0; round < 2000; ++round) {
        const ReebGraph graph = testing::random_case(random).graph;
        std::vector<std::size_t> as_upper(graph.nodes.size()), as_lower(graph.nodes.size());
        for (const auto& pair : persistence_pairs(graph)) {
            ++as_lower[pair.lower];
            ++as_upper[pair.upper];
        }
        for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
            const auto& node = graph.nodes[n];
            EXPECT_EQ(as_upper[n], (node.down ? node.down - 1 : 0) + (node.up == 0));
            EXPECT_EQ(as_lower[n], (node.up ? node.up - 1 : 0) + (node.down == 0));
        }
    }
}

TEST(Persistence, stays_when_a_constant_is_added) {
    std::mt19937_64 random(26);
    for (int round = 0; round < 500; ++round) {
        ReebGraph graph = testing::random_case(random).graph;
        const auto before = persistence_pairs(graph);
        for (auto& node : graph.nodes) node.value += 4'999'999;
        EXPECT_EQ(persistence_pairs(graph), before);
    }
}

TEST(Persistence, swaps_joins_and_splits_upside_down) {
    std::mt19937_64 random(27);
    for (int round = 0; round < 2000; ++round) {
        const ReebGraph graph = testing::random_case(random).graph;
        const auto last = static_cast<std::uint32_t>(graph.nodes.size()) - 1;
        auto expected = persistence_pairs(graph);
        for (auto& pair : expected) {
            pair = {pair.kind == PairKind::Join    ? PairKind::Split
                    : pair.kind == PairKind::Split ? PairKind::Join
                                                   : pair.kind,
                    last - pair.upper, last - pair.lower, pair.persistence};
        }
        EXPECT_EQ(triples(persistence_pairs(testing::upside_down(graph))), triples(expected));
    }
}

// A torus that stands up: two extremes, and the loop between its two saddles.
TEST(Persistence, of_a_standing_torus_is_its_height_and_that_of_its_hole) {
    const double R = 3, r = 1;
    const TriMesh mesh = half_edge_mesh(shapes::torus(R, r, 60, 30));
    const auto pairs = persistence_pairs(reeb_graph(mesh, height_field(mesh, {1, 0, 0})));
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].kind, PairKind::Component);
    EXPECT_NEAR(pairs[0].persistence, 2 * (R + r), 1e-9);
    EXPECT_EQ(pairs[1].kind, PairKind::Loop);
    EXPECT_NEAR(pairs[1].persistence, 2 * (R - r), 1e-9);
}

TEST(Persistence, of_nothing_and_of_lone_nodes) {
    EXPECT_TRUE(persistence_pairs(ReebGraph()).empty());
    const auto pairs = persistence_pairs(made(2, {}).graph);
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[1], (PersistencePair{PairKind::Component, 1, 1, 0.0}));
}

//! The sides of a cycle lead from its lower to its upper node, between them, and meet no node twice.
void expect_sound(const LoopCycle& cycle, const ReebGraph& graph) {
    std::multiset<std::uint32_t> met;
    for (const auto& side : cycle.sides) {
        ASSERT_FALSE(side.empty());
        std::uint32_t at = cycle.pair.lower;
        for (const std::uint32_t a : side) {
            const ReebArc& arc = graph.arcs[a];
            ASSERT_TRUE(arc.lower == at || arc.upper == at);
            met.insert(at);
            at = arc.lower == at ? arc.upper : arc.lower;
            EXPECT_GE(at, cycle.pair.lower);
            EXPECT_LE(at, cycle.pair.upper);
        }
        EXPECT_EQ(at, cycle.pair.upper);
        met.insert(at);
    }
    for (const std::uint32_t n : met)
        EXPECT_EQ(met.count(n), n == cycle.pair.lower || n == cycle.pair.upper ? 2u : 1u);
}

//! How many of these sets of arcs are independent modulo 2.
std::size_t rank(const std::vector<LoopCycle>& cycles, std::size_t arcs) {
    std::vector<std::vector<char>> basis(arcs);
    std::size_t result = 0;
    for (const auto& cycle : cycles) {
        std::vector<char> row(arcs, 0);
        for (const auto& side : cycle.sides)
            for (const std::uint32_t a : side) row[a] ^= 1;
        for (std::size_t a = 0; a < arcs; ++a) {
            if (!row[a]) continue;
            if (basis[a].empty()) {
                basis[a] = row;
                ++result;
                break;
            }
            for (std::size_t b = 0; b < arcs; ++b) row[b] ^= basis[a][b];
        }
    }
    return result;
}

TEST(LoopCycles, are_a_basis_of_simple_cycles_between_the_nodes_of_their_pairs) {
    std::mt19937_64 random(28);
    auto graphs = surface_graphs();
    for (int round = 0; round < 3000; ++round)
        graphs.push_back(testing::random_case(random, round % 20 ? 12 : 60).graph);
    for (const ReebGraph& graph : graphs) {
        const auto cycles = loop_cycles(graph);
        std::vector<PersistencePair> expected = persistence_pairs(graph), found;
        std::erase_if(expected, [](const auto& pair) { return pair.kind != PairKind::Loop; });
        for (const auto& cycle : cycles) found.push_back(cycle.pair);
        ASSERT_EQ(found, expected);
        for (const auto& cycle : cycles) expect_sound(cycle, graph);
        ASSERT_EQ(rank(cycles, graph.arcs.size()), graph.loops() - graph.hidden_loops);
    }
}

TEST(LoopCycles, of_two_sides_with_branches_lists_arcs_bottom_to_top) {
    // 0 - 1 splits; one side passes 2, where a branch to 5 leaves; the sides meet in 4, below 6; 3 hangs below that.
    const ReebGraph graph = made(7, {{0, 1}, {1, 2}, {1, 4}, {2, 4}, {2, 5}, {3, 4}, {4, 6}}).graph;
    const auto cycles = loop_cycles(graph);
    ASSERT_EQ(cycles.size(), 1u);
    EXPECT_EQ(cycles[0].pair, (PersistencePair{PairKind::Loop, 1, 4, 3.0}));
    auto sides = cycles[0].sides;
    std::ranges::sort(sides);
    EXPECT_EQ(sides[0], (std::vector<std::uint32_t>{1, 3}));
    EXPECT_EQ(sides[1], (std::vector<std::uint32_t>{2}));
    EXPECT_TRUE(is_monotone(cycles[0], graph));
    EXPECT_TRUE(loop_cycles(graph, 3.5).empty());
}

TEST(LoopCycles, that_must_sink_on_their_way_up_do) {
    const ReebGraph graph = made(4, {{0, 2}, {1, 2}, {1, 3}, {0, 3}}).graph;
    const auto cycles = loop_cycles(graph);
    ASSERT_EQ(cycles.size(), 1u);
    EXPECT_FALSE(is_monotone(cycles[0], graph));
}

}  // namespace
}  // namespace stratareeb
