// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/graph_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

//! Nodes at the values 0, 1, 2, … with arcs between them.
ReebGraph graph_of(std::size_t nodes, std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs) {
    ReebGraph graph;
    graph.nodes.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) graph.nodes[n].value = double(n);
    std::ranges::sort(arcs);
    for (const auto& [lower, upper] : arcs) graph.arcs.push_back({.lower = lower, .upper = upper});
    return graph;
}

bool pass_together(const ReebGraph& graph, std::size_t a, std::size_t b) {
    const ReebArc &one = graph.arcs[a], &other = graph.arcs[b];
    return std::max(one.lower, other.lower) < std::min(one.upper, other.upper);
}

void expect_apart(const ReebGraph& graph, const GraphColumns& columns) {
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
        EXPECT_GE(columns.arc_x[a], 0);
        EXPECT_LE(columns.arc_x[a], columns.width);
        for (std::size_t b = 0; b < a; ++b)
            if (pass_together(graph, a, b)) {
                EXPECT_GE(std::abs(columns.arc_x[a] - columns.arc_x[b]), 1 - 1e-9) << a << " " << b;
            }
    }
}

//! Arcs that a node's way to the column of one of its arcs runs across.
std::size_t crossings(const ReebGraph& graph, const GraphColumns& columns) {
    std::size_t count = 0;
    for (std::size_t a = 0; a < graph.arcs.size(); ++a)
        for (const std::uint32_t n : {graph.arcs[a].lower, graph.arcs[a].upper}) {
            const auto [low, high] = std::minmax(columns.arc_x[a], columns.node_x[n]);
            for (std::size_t b = 0; b < graph.arcs.size(); ++b)
                count += graph.arcs[b].lower < n && n < graph.arcs[b].upper && low < columns.arc_x[b] &&
                         columns.arc_x[b] < high;
        }
    return count;
}

TEST(GraphColumns, a_torus_is_a_ring_on_a_stem) {
    const ReebGraph graph = graph_of(4, {{0, 1}, {1, 2}, {1, 2}, {2, 3}});
    const std::vector<double> preferred{0, 5, -5, 0};
    const GraphColumns columns = graph_columns(graph, preferred);
    EXPECT_EQ(columns.width, 1);
    EXPECT_EQ(columns.arc_x, (std::vector<double>{0.5, 1, 0, 0.5}));
    EXPECT_EQ(columns.node_x, (std::vector<double>(4, 0.5)));
}

TEST(GraphColumns, trees_are_drawn_without_crossings) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        // Minima 0 … n-1 that merge one after the other, in any order: a join tree; and the same upside down.
        const std::uint32_t n = 2 + random() % 20;
        std::vector<std::uint32_t> open(n);
        for (std::uint32_t i = 0; i < n; ++i) open[i] = i;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
        std::uint32_t next = n;
        while (open.size() > 1) {
            std::ranges::shuffle(open, random);
            arcs.emplace_back(open.back(), next);
            open.pop_back();
            arcs.emplace_back(open.back(), next);
            open.back() = next++;
        }
        if (random() % 2)
            for (auto& [lower, upper] : arcs) {
                std::swap(lower, upper);
                lower = next - 1 - lower;
                upper = next - 1 - upper;
            }
        const ReebGraph graph = graph_of(next, arcs);
        std::vector<double> preferred(graph.arcs.size());
        for (double& x : preferred) x = double(random() % 100);
        const GraphColumns columns = graph_columns(graph, preferred);
        expect_apart(graph, columns);
        EXPECT_EQ(crossings(graph, columns), 0u) << round;
    }
}

TEST(GraphColumns, arcs_of_any_graph_stay_apart) {
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        const std::uint32_t nodes = 1 + random() % 30;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
        for (auto k = random() % 60; k > 0 && nodes > 1; --k) {
            const std::uint32_t a = random() % nodes, b = random() % nodes;
            if (a != b) arcs.emplace_back(std::min(a, b), std::max(a, b));
        }
        const ReebGraph graph = graph_of(nodes, arcs);
        std::vector<double> preferred(graph.arcs.size());
        for (double& x : preferred) x = double(random() % 100);
        const GraphColumns columns = graph_columns(graph, preferred);
        expect_apart(graph, columns);
        for (const double x : columns.node_x) EXPECT_TRUE(x >= 0 && x <= columns.width);
    }
}

}  // namespace
}  // namespace stratareeb
