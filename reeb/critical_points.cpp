// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_points.h"

#include <algorithm>

#include "reeb/reeb_graph.h"
#include "reeb/vertex_descent.h"

namespace stratareeb {

namespace {

CriticalPoint point_of(const CriticalLink& link, const ScalarField& field) {
    const int fans = static_cast<int>(link.fans), strands = static_cast<int>(link.strands);
    CriticalPoint point{
        .vertex = link.vertex, .value = field[link.vertex], .on_boundary = link.is_on_boundary()};
    const bool whole_circle_below = strands == 0 && fans > 0 && !link.is_on_boundary();
    point.index = whole_circle_below ? 1 : 1 - fans;
    if (fans == 0) {
        point.type = CriticalType::Minimum;
    } else if (strands == 0) {
        point.type = CriticalType::Maximum;
    } else {
        point.type = CriticalType::Saddle;
        point.multiplicity = std::max(fans, strands) - 1;
    }
    return point;
}

}  // namespace

std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field) {
    check_field(mesh, field);
    const VertexOrder order = vertex_order(field);
    std::vector<CriticalPoint> points;
    const VertexDescent descent = vertex_descent(mesh, order);
    points.reserve(descent.critical.size());
    for (const CriticalLink& link : descent.critical) points.push_back(point_of(link, field));
    std::ranges::sort(points, {}, [&](const CriticalPoint& point) { return order.rank[point.vertex]; });
    return points;
}

std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field,
                                           const ReebGraph& graph) {
    std::vector<CriticalPoint> points = critical_points(mesh, field);
    std::uint32_t node = 0;  // both go from bottom to top
    for (CriticalPoint& point : points)
        if (node < graph.nodes.size() && graph.nodes[node].vertex == point.vertex) point.node = node++;
    return points;
}

}  // namespace stratareeb
