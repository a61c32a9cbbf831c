// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_link.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

//! Between two outgoing half-edges that follow each other, `h` first: the link's half-edge in their triangle, turned to the
//! outside of the star. Outgoing half-edges turn clockwise: the next one is that of the triangle to the right of h.
Halfedge link_edge(const TriMesh& mesh, Halfedge h) {
    const Halfedge o = mesh.opposite_halfedge_handle(h);  // of the triangle on the right, towards the vertex
    return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(o));
}

void read_spokes(const TriMesh& mesh, VertexLink& link) {
    link.spokes.clear();
    const Halfedge first = mesh.halfedge_handle(TriMesh::VertexHandle(static_cast<int>(link.vertex)));
    link.is_path = first.is_valid() && mesh.is_boundary(first);
    if (!first.is_valid()) return;
    Halfedge h = first;
    do {
        link.spokes.push_back(h);
        h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
    } while (h != first);
}

}  // namespace

void read_link(const TriMesh& mesh, const std::vector<std::uint32_t>& rank, std::uint32_t vertex,
               VertexLink& link) {
    link.vertex = vertex;
    link.lower.clear();
    link.upper.clear();
    link.lower_fans.clear();
    link.strands.clear();
    link.all_above = false;
    read_spokes(mesh, link);
    const std::size_t count = link.spokes.size();
    if (count == 0) return;
    const auto is_upper = [&](std::size_t i) {
        return rank[static_cast<std::size_t>(mesh.to_vertex_handle(link.spokes[i % count]).idx())] >
               rank[vertex];
    };
    // Start a round trip at a change from one kind to the other; a path starts at its start.
    std::size_t start = 0;
    if (!link.is_path)
        while (start < count && is_upper(start) == is_upper(start + count - 1)) ++start;
    if (start == count) {
        start = 0;
        link.all_above = is_upper(0);
    }
    bool before = false;
    for (std::size_t i = start; i < start + count; ++i) {
        const bool upper = is_upper(i), fan_starts = i == start || upper != before;
        before = upper;
        if (!upper) {
            if (fan_starts) link.lower_fans.push_back({link.lower.size(), link.lower.size()});
            link.lower.push_back(link.spokes[i % count]);
            link.lower_fans.back().end = link.lower.size();
            if (fan_starts && i > start)  // the strand before ends here
                link.strands.back().last_exit = link_edge(mesh, link.spokes[(i - 1) % count]);
            continue;
        }
        if (fan_starts) {
            link.strands.emplace_back().begin = link.upper.size();
            const bool from_boundary = link.is_path && i == 0;
            if (!from_boundary && !link.all_above)
                link.strands.back().first_exit = link_edge(mesh, link.spokes[(i + count - 1) % count]);
        }
        link.upper.push_back(link.spokes[i % count]);
        link.strands.back().end = link.upper.size();
    }
    const bool closes_round = before && !link.is_path && !link.all_above;
    if (closes_round)
        link.strands.back().last_exit = link_edge(mesh, link.spokes[(start + count - 1) % count]);
}

}  // namespace stratareeb
