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

}  // namespace

void read_link(const TriMesh& mesh, const std::vector<std::uint32_t>& rank, std::uint32_t vertex,
               VertexLink& link) {
    link.vertex = vertex;
    link.lower_edges.clear();
    link.lower_fans = 0;
    link.strands.clear();
    const TriMesh::VertexHandle v(static_cast<int>(vertex));
    link.is_path = mesh.is_boundary(v);
    link.all_above = false;

    thread_local std::vector<Halfedge> spokes;
    spokes.clear();
    for (const Halfedge h : mesh.voh_range(v)) spokes.push_back(h);
    const std::size_t count = spokes.size();
    if (count == 0) return;
    const auto is_upper = [&](std::size_t i) {
        return rank[static_cast<std::size_t>(mesh.to_vertex_handle(spokes[i % count]).idx())] > rank[vertex];
    };
    const auto edge = [&](std::size_t i) {
        return static_cast<std::uint32_t>(mesh.edge_handle(spokes[i % count]).idx());
    };
    // Start a round trip at a change from one kind to the other; a path starts at its start.
    std::size_t start = 0;
    if (!link.is_path)
        while (start < count && is_upper(start) == is_upper(start + count - 1)) ++start;
    if (start == count) {
        start = 0;
        link.all_above = is_upper(0);
    }
    for (std::size_t i = start; i < start + count; ++i) {
        const bool fan_starts = i == start || is_upper(i) != is_upper(i - 1);
        if (!is_upper(i)) {
            link.lower_fans += fan_starts;
            link.lower_edges.push_back(edge(i));
            continue;
        }
        if (fan_starts) {
            auto& strand = link.strands.emplace_back();
            const bool from_boundary = link.is_path && i == 0;
            if (!from_boundary && !link.all_above)
                strand.first_exit = link_edge(mesh, spokes[(i + count - 1) % count]);
        }
        link.strands.back().edges.push_back(edge(i));
        const bool fan_ends = i + 1 == start + count || !is_upper(i + 1);
        const bool at_boundary = link.is_path && i + 1 == count;
        if (fan_ends && !at_boundary && !link.all_above)
            link.strands.back().last_exit = link_edge(mesh, spokes[i % count]);
    }
}

}  // namespace stratareeb
