// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! The way of a contour past a vertex that it has just risen over: a fan of upward edges and, at either side, the edge of
//! the link that it crosses next; none where it ends at the vertex, on the mesh's boundary.
struct Strand {
    std::vector<std::uint32_t> edges;  // from the vertex up, in turn
    TriMesh::HalfedgeHandle first_exit,
        last_exit;  // half-edges of the link, seen from outside the star; invalid = boundary
};

//! A vertex's neighbours in a total order of all vertices, as the contours just below and just above it see them.
struct VertexLink {
    std::uint32_t vertex = 0;
    std::vector<std::uint32_t> lower_edges;
    std::size_t lower_fans = 0;
    std::vector<Strand> strands;
    bool is_path = false;    // the vertex is on the boundary
    bool all_above = false;  // a minimum inside: the strand is a ring without ends
};

//! Fill `link` for a vertex; `rank` is each vertex's place in the order.
void read_link(const TriMesh& mesh, const std::vector<std::uint32_t>& rank, std::uint32_t vertex,
               VertexLink& link);

}  // namespace stratareeb
