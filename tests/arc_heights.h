// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of graphs as pairs of heights, to compare graphs whose nodes all have heights of their own.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/reeb_graph.h"

namespace stratareeb::testing {

inline std::vector<std::pair<double, double>> arcs_of(const EnhancedReebGraph& graph) {
    std::vector<std::pair<double, double>> arcs;
    for (const auto& edge : graph.edges)
        arcs.emplace_back(graph.nodes[edge.from].position.z, graph.nodes[edge.to].position.z);
    std::ranges::sort(arcs);
    return arcs;
}

inline std::vector<std::pair<double, double>> arcs_of(const ReebGraph& graph) {
    std::vector<std::pair<double, double>> arcs;
    for (const ReebArc& arc : graph.arcs)
        arcs.emplace_back(graph.nodes[arc.lower].value, graph.nodes[arc.upper].value);
    std::ranges::sort(arcs);
    return arcs;
}

}  // namespace stratareeb::testing
