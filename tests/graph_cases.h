// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <ranges>
#include <utility>
#include <vector>

#include "reeb/reeb_graph.h"

//! Graphs with a field, made at random: what a Reeb graph may be, and some of what no surface has.
namespace stratareeb::testing {

using NodePair = std::pair<std::uint32_t, std::uint32_t>;

struct GraphCase {
    ReebGraph graph;
    ScalarField field;  // by vertex
};

inline std::size_t count_components(const ReebGraph& graph) {
    std::vector<std::uint32_t> piece(graph.nodes.size());
    std::iota(piece.begin(), piece.end(), 0u);
    std::size_t count = piece.size();
    for (const ReebArc& arc : graph.arcs) {
        const std::uint32_t from = piece[arc.lower], to = piece[arc.upper];
        if (from == to) continue;
        --count;
        std::ranges::replace(piece, from, to);
    }
    return count;
}

//! Degrees, types and components from arcs.
inline void complete(ReebGraph& graph) {
    std::ranges::stable_sort(graph.arcs, {}, &ReebArc::lower);
    for (auto& node : graph.nodes) node.down = node.up = 0;
    for (const ReebArc& arc : graph.arcs) {
        ++graph.nodes[arc.lower].up;
        ++graph.nodes[arc.upper].down;
    }
    for (auto& node : graph.nodes)
        node.type = node.down == 0 ? CriticalType::Minimum
                    : node.up == 0 ? CriticalType::Maximum
                                   : CriticalType::Saddle;
    graph.components = count_components(graph);
}

//! Vertex numbers in the order of the values, or else at random but for equal values.
inline std::vector<std::uint32_t> vertex_numbers(const std::vector<double>& rising, std::mt19937_64& random) {
    std::vector<std::uint32_t> number(rising.size());
    std::iota(number.begin(), number.end(), 0u);
    std::ranges::shuffle(number, random);
    for (auto from = rising.begin(); from != rising.end();) {
        const auto to = std::upper_bound(from, rising.end(), *from);
        std::sort(number.begin() + (from - rising.begin()), number.begin() + (to - rising.begin()));
        from = to;
    }
    return number;
}

//! A graph with these arcs over `nodes` nodes and about `extra` further vertices on its arcs. Values are whole numbers below
//! `range`: the smaller it is, the more ties.
inline GraphCase graph_case(std::uint32_t nodes, const std::vector<NodePair>& arcs, std::uint32_t extra,
                            std::uint64_t range, std::mt19937_64& random) {
    GraphCase result;
    for (const auto& [lower, upper] : arcs) result.graph.arcs.push_back({lower, upper});
    std::ranges::stable_sort(result.graph.arcs, {}, &ReebArc::lower);
    std::vector<std::pair<double, std::uint32_t>>
        places;  // a node's number, or a place between; the arc through it
    for (std::uint32_t n = 0; n < nodes; ++n) places.emplace_back(n, ReebGraph::kNone);
    for (std::uint32_t i = 0; i < extra && !arcs.empty(); ++i) {
        const auto a = static_cast<std::uint32_t>(random() % arcs.size());
        const ReebArc& arc = result.graph.arcs[a];
        const double below = arc.lower + static_cast<double>(random() % (arc.upper - arc.lower));
        places.emplace_back(below + 0.5, a);
    }
    std::ranges::sort(places);
    std::vector<double> rising(places.size());
    for (double& value : rising) value = static_cast<double>(random() % range);
    std::ranges::sort(rising);
    const std::vector<std::uint32_t> number = vertex_numbers(rising, random);
    result.field.resize(places.size());
    result.graph.vertex_arc.assign(places.size(), ReebGraph::kNone);
    for (std::size_t p = 0; p < places.size(); ++p) {
        result.field[number[p]] = rising[p];
        result.graph.vertex_arc[number[p]] = places[p].second;
        if (places[p].second == ReebGraph::kNone)
            result.graph.nodes.push_back({number[p], rising[p], CriticalType::Saddle, 0, 0});
    }
    for (std::uint32_t a = 0; a < result.graph.arcs.size(); ++a)
        for (const std::uint32_t n : {result.graph.arcs[a].lower, result.graph.arcs[a].upper})
            result.graph.vertex_arc[result.graph.nodes[n].vertex] = a;
    complete(result.graph);
    return result;
}

//! Any multigraph: several components, nodes of any degrees, isolated ones.
inline GraphCase random_case(std::mt19937_64& random, std::uint32_t max_nodes = 12) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % max_nodes);
    std::vector<NodePair> arcs;
    for (auto count = nodes > 1 ? random() % (2 * nodes) : 0; count > 0; --count) {
        const auto a = static_cast<std::uint32_t>(random() % nodes),
                   b = static_cast<std::uint32_t>(random() % nodes);
        if (a != b) arcs.emplace_back(std::min(a, b), std::max(a, b));
    }
    return graph_case(nodes, arcs, static_cast<std::uint32_t>(random() % 30), 1 + random() % 60, random);
}

//! Any forest.
inline GraphCase random_forest(std::mt19937_64& random, std::uint32_t max_nodes = 16) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % max_nodes);
    std::vector<std::uint32_t> place(nodes);
    std::iota(place.begin(), place.end(), 0u);
    std::ranges::shuffle(place, random);
    std::vector<NodePair> arcs;
    for (std::uint32_t n = 1; n < nodes; ++n) {
        if (random() % 12 == 0) continue;
        const std::uint32_t a = place[n], b = place[random() % n];
        arcs.emplace_back(std::min(a, b), std::max(a, b));
    }
    return graph_case(nodes, arcs, static_cast<std::uint32_t>(random() % 30), 1 + random() % 90, random);
}

//! Upside down: node n becomes node (nodes - 1 - n).
inline ReebGraph upside_down(const ReebGraph& graph) {
    ReebGraph result;
    const auto last = static_cast<std::uint32_t>(graph.nodes.size()) - 1;
    for (const ReebNode& node : std::views::reverse(graph.nodes)) {
        result.nodes.push_back(node);
        result.nodes.back().value = -node.value;
    }
    for (const ReebArc& arc : graph.arcs) result.arcs.push_back({last - arc.upper, last - arc.lower});
    complete(result);
    return result;
}

}  // namespace stratareeb::testing
