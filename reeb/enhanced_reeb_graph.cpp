// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/enhanced_reeb_graph.h"

#include <numeric>

namespace stratareeb {

std::string text_of(const GraphId& id) {
    if (const auto* number = std::get_if<std::int64_t>(&id)) return std::to_string(*number);
    return '"' + std::get<std::string>(id) + '"';
}

Curve curve_of(const EnhancedReebGraph& graph, const EnhancedEdge& edge) {
    Curve curve = edge.curve;
    curve.points.insert(curve.points.begin(), graph.nodes[edge.from].position);
    curve.points.push_back(graph.nodes[edge.to].position);
    return curve;
}

std::size_t loops_of(const EnhancedReebGraph& graph) {
    std::vector<std::uint32_t> parent(graph.nodes.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t n) {
        while (parent[n] != n) n = parent[n] = parent[parent[n]];
        return n;
    };
    std::size_t loops = 0;
    for (const EnhancedEdge& edge : graph.edges) {
        const std::uint32_t a = root(edge.from), b = root(edge.to);
        loops += a == b;
        parent[a] = b;
    }
    return loops;
}

}  // namespace stratareeb
