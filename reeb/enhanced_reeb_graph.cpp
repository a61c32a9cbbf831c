// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/enhanced_reeb_graph.h"

#include <algorithm>

#include "mesh/soup_topology.h"

namespace stratareeb {

std::string text_of(const GraphId& id) {
    if (const auto* number = std::get_if<std::int64_t>(&id)) return std::to_string(*number);
    return '"' + std::get<std::string>(id) + '"';
}

bool has_level_nodes(const EnhancedReebGraph& graph) {
    return std::ranges::any_of(graph.nodes,
                               [](const EnhancedNode& node) { return node.form != NodeForm::Point; });
}

Curve curve_of(const EnhancedReebGraph& graph, const EnhancedEdge& edge) {
    Curve curve = edge.curve;
    curve.points.insert(curve.points.begin(), graph.nodes[edge.from].position);
    curve.points.push_back(graph.nodes[edge.to].position);
    return curve;
}

std::size_t loops_of(const EnhancedReebGraph& graph) {
    DisjointSets pieces(graph.nodes.size());
    std::size_t loops = 0;
    for (const EnhancedEdge& edge : graph.edges) {
        loops += pieces.find(edge.from) == pieces.find(edge.to);
        pieces.unite(edge.from, edge.to);
    }
    return loops;
}

}  // namespace stratareeb
