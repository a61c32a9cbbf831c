// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_curves.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace stratareeb {

namespace {

Point3 place(const TriMesh& mesh, const ReebNode& node) {
    const auto& p = mesh.point(TriMesh::VertexHandle(static_cast<int>(node.vertex)));
    return {p[0], p[1], p[2]};
}

}  // namespace

Point3 center_of(const Contour& contour) {
    const std::vector<Point3>& points = contour.points;
    const Point3 origin = points.front();  // sums stay exact far from zero
    Point3 sum{0, 0, 0};
    double length = 0;
    const std::size_t pieces = contour.closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Point3 &a = points[i], &b = points[(i + 1) % points.size()];
        const double piece = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
        length += piece;
        sum.x += piece * ((a.x - origin.x) + (b.x - origin.x)) / 2;
        sum.y += piece * ((a.y - origin.y) + (b.y - origin.y)) / 2;
        sum.z += piece * ((a.z - origin.z) + (b.z - origin.z)) / 2;
    }
    if (length == 0) return origin;
    return {origin.x + sum.x / length, origin.y + sum.y / length, origin.z + sum.z / length};
}

std::vector<std::vector<Point3>> arc_curves(const TriMesh& mesh, const ReebGraph& graph,
                                            const ArcIndex& index, std::size_t samples) {
    std::vector<std::vector<Point3>> curves(graph.arcs.size());
    tbb::parallel_for(std::size_t{0}, curves.size(), [&](std::size_t a) {
        const ReebNode &lower = graph.nodes[graph.arcs[a].lower], &upper = graph.nodes[graph.arcs[a].upper];
        curves[a].push_back(place(mesh, lower));
        for (std::size_t k = 1; k <= samples; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(samples + 1);
            const double level = lower.value + share * (upper.value - lower.value);
            if (!(lower.value < level && level < upper.value)) continue;
            curves[a].push_back(center_of(index.contour(static_cast<std::uint32_t>(a), level)));
        }
        curves[a].push_back(place(mesh, upper));
    });
    return curves;
}

}  // namespace stratareeb
