// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! The way of a contour past a vertex that it has just risen over: a fan of upward edges and, at either side, the edge of
//! the link that it crosses next; none where it ends at the vertex, on the mesh's boundary.
struct Strand {
    std::size_t begin = 0, end = 0;  // in VertexLink::upper
    TriMesh::HalfedgeHandle first_exit,
        last_exit;  // half-edges of the link, seen from outside the star; invalid = boundary
};

//! Neighbours below that follow each other around the vertex: one contour just below crosses the edges to all of them.
struct LowerFan {
    std::size_t begin = 0, end = 0;  // in VertexLink::lower
};

//! A vertex's neighbours in a total order of all vertices, as the contours just below and just above it see them.
struct VertexLink {
    std::uint32_t vertex = 0;
    std::vector<TriMesh::HalfedgeHandle> lower, upper;  // outgoing half-edges, fan by fan, clockwise
    std::vector<LowerFan> lower_fans;
    std::vector<Strand> strands;
    bool is_path = false;    // the vertex is on the boundary
    bool all_above = false;  // a minimum inside: the strand is a ring without ends

    std::span<const TriMesh::HalfedgeHandle> edges_of(const Strand& strand) const {
        return std::span(upper).subspan(strand.begin, strand.end - strand.begin);
    }
    std::span<const TriMesh::HalfedgeHandle> edges_of(const LowerFan& fan) const {
        return std::span(lower).subspan(fan.begin, fan.end - fan.begin);
    }

    std::vector<TriMesh::HalfedgeHandle> spokes;  // all outgoing half-edges, clockwise; a path from its start
};

//! Fill `link` for a vertex, in its memory; `rank` is each vertex's place in the order.
void read_link(const TriMesh& mesh, const std::vector<std::uint32_t>& rank, std::uint32_t vertex,
               VertexLink& link);

}  // namespace stratareeb
