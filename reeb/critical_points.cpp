// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_points.h"

#include <algorithm>

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;

//! Arcs of lower and of upper neighbours around a vertex.
struct Link {
    int lower = 0, upper = 0;
    bool is_path = false;  // at a boundary
};

Link link_of(const TriMesh& mesh, const ScalarField& field, Vertex v) {
    const auto center = static_cast<std::uint32_t>(v.idx());
    Link link{.is_path = mesh.is_boundary(v)};
    bool first = false, before = false, any = false;
    // Outgoing half-edges turn clockwise and, at a boundary, start so that the path is walked in one go.
    for (const auto h : mesh.voh_range(v)) {
        const bool below =
            is_below(field, static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx()), center);
        if (!any) first = below;
        if (!any || below != before) ++(below ? link.lower : link.upper);
        any = true;
        before = below;
    }
    if (any && !link.is_path && link.lower + link.upper > 1 && first == before)
        --(first ? link.lower : link.upper);
    return link;
}

}  // namespace

std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field) {
    check_field(mesh, field);
    std::vector<CriticalPoint> points;
    for (const Vertex v : mesh.vertices()) {
        const Link link = link_of(mesh, field, v);
        const bool whole_circle_below = !link.is_path && link.upper == 0 && link.lower > 0;
        CriticalPoint point{.vertex = static_cast<std::uint32_t>(v.idx()),
                            .value = field[static_cast<std::size_t>(v.idx())],
                            .index = whole_circle_below ? 1 : 1 - link.lower,
                            .on_boundary = link.is_path};
        if (link.lower == 0) {
            point.type = CriticalType::Minimum;
        } else if (link.upper == 0) {
            point.type = CriticalType::Maximum;
        } else if (link.lower > 1 || link.upper > 1) {
            point.type = CriticalType::Saddle;
            point.multiplicity = std::max(link.lower, link.upper) - 1;
        } else {
            continue;
        }
        points.push_back(point);
    }
    std::ranges::sort(points, [&](const CriticalPoint& a, const CriticalPoint& b) {
        return is_below(field, a.vertex, b.vertex);
    });
    return points;
}

}  // namespace stratareeb
