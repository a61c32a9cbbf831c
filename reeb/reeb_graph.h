// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/critical_points.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! A vertex at which contours appear, vanish, merge or split.
struct ReebNode {
    std::uint32_t vertex = 0;
    double value = 0;
    CriticalType type = CriticalType::Minimum;
    std::uint32_t down = 0, up = 0;  // arcs that end here from below, arcs that start here
};

//! A family of contours that move, without merging or splitting, from one node up to another.
struct ReebArc {
    std::uint32_t lower = 0, upper = 0;  // nodes
    // An edge of the mesh that the arc's contours cross just below its upper end: from this vertex up to that one.
    std::uint32_t below_top = 0, top = 0;
};

//! The Reeb graph of a field on a surface (G. Reeb 1946): its points are the connected pieces of the field's level sets.
struct ReebGraph {
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<ReebNode> nodes;  // from bottom to top
    std::vector<ReebArc> arcs;    // in the order of their lower nodes
    std::vector<std::uint32_t>
        vertex_arc;  // the arc through each vertex; at a node an arc that starts or else ends there
    std::vector<std::uint32_t>
        triangle_arc;            // by face: of the contour through it just below its middle vertex
    std::size_t components = 0;  // of the graph, which are those of the surface

    std::size_t hidden_loops = 0;  // handles that multiple saddles open and close at one vertex

    //! Independent cycles, hidden ones included: the genus, summed over components, of a closed orientable surface (K.
    //! Cole-McLaughlin et al. 2003). Hidden ones are counted on surfaces without boundary.
    std::size_t loops() const { return arcs.size() + components + hidden_loops - nodes.size(); }
};

//! The Reeb graph of any 2-manifold, with or without boundary, of any genus and with any number of components. Vertices are
//! swept in order (value, then index); each takes its contour over from the highest neighbour below, names of contours being
//! merged by union-find. Where a contour may split, its pieces are walked in step until all but one are closed, so that the
//! longest is never walked to its end. Time: a sort, a pass over the mesh (both on all threads, with the same result), and
//! the lengths of the shorter pieces at splits. Vertices at which an open contour only closes, or a closed one opens, are no
//! nodes. Vertices without faces are nodes without arcs.
//! \throw InvalidInput if the field does not fit the mesh.
ReebGraph reeb_graph(const TriMesh& mesh, const ScalarField& field);

}  // namespace stratareeb
