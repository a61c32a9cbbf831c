// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/loop_core.h"

#include <algorithm>
#include <array>

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ReebGraph::kNone;

//! The graph while leaves are taken off. The exclusive or of a node's arcs is the arc itself once only one is left.
struct Pruning {
    explicit Pruning(const ReebGraph& reeb_graph) : graph(reeb_graph), arcs(graph.arcs.size(), 1) {
        nodes.resize(graph.nodes.size());
        for (std::uint32_t a = 0; a < arcs.size(); ++a) toggle(a, +1);
        for (std::uint32_t n = 0; n < nodes.size(); ++n)
            for (std::uint32_t leaf = n; is_leaf(leaf);) leaf = without_leaf(leaf);
    }

    struct Node {
        std::array<std::uint32_t, 2> degree{}, mixed{};  // of arcs down, arcs up
    };

    void toggle(std::uint32_t a, int change) {
        const auto touch = [&](std::uint32_t node, int side) {
            nodes[node].degree[side] += static_cast<std::uint32_t>(change);
            nodes[node].mixed[side] ^= a;
        };
        touch(graph.arcs[a].lower, 1);
        touch(graph.arcs[a].upper, 0);
    }

    bool is_leaf(std::uint32_t n) const { return nodes[n].degree[0] + nodes[n].degree[1] == 1; }

    //! \return the leaf's only neighbour, which may be a leaf now.
    std::uint32_t without_leaf(std::uint32_t n) {
        const int side = nodes[n].degree[1] == 1;
        const std::uint32_t a = nodes[n].mixed[side];
        arcs[a] = 0;
        toggle(a, -1);
        return side ? graph.arcs[a].upper : graph.arcs[a].lower;
    }

    bool is_inside(std::uint32_t n) const { return nodes[n].degree[0] == 1 && nodes[n].degree[1] == 1; }
    bool is_gone(std::uint32_t n) const { return nodes[n].degree[0] + nodes[n].degree[1] == 0; }

    const ReebGraph& graph;
    std::vector<Node> nodes;
    std::vector<char> arcs;  // still there?
};

}  // namespace

LoopCore loop_core(const ReebGraph& graph) {
    const Pruning pruned(graph);
    LoopCore core;
    std::vector<std::uint32_t> core_node(graph.nodes.size(), kNone);
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
        if (pruned.is_gone(n) || pruned.is_inside(n)) continue;
        core_node[n] = static_cast<std::uint32_t>(core.nodes.size());
        core.nodes.push_back(n);
    }
    for (std::uint32_t first = 0; first < graph.arcs.size(); ++first) {
        if (!pruned.arcs[first] || core_node[graph.arcs[first].lower] == kNone) continue;
        CoreArc arc{.lower = core_node[graph.arcs[first].lower], .arcs = {first}};
        std::uint32_t top = graph.arcs[first].upper;
        for (; core_node[top] == kNone; top = graph.arcs[arc.arcs.back()].upper)
            arc.arcs.push_back(pruned.nodes[top].mixed[1]);
        arc.upper = core_node[top];
        core.arcs.push_back(std::move(arc));
    }
    std::ranges::stable_sort(core.arcs, {}, &CoreArc::upper);
    return core;
}

}  // namespace stratareeb
