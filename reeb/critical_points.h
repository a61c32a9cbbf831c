// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

struct ReebGraph;

enum class CriticalType { Minimum, Saddle, Maximum };

//! A vertex at which the level set is not simply a line: just below or just above it, the number of its pieces near the vertex
//! is not one.
struct CriticalPoint {
    static constexpr std::uint32_t kNoNode = ~0u;

    std::uint32_t vertex = 0;
    double value = 0;
    CriticalType type = CriticalType::Minimum;
    int multiplicity = 1;  // of a saddle: 1 simple, 2 for a monkey saddle
    int index = 1;         // 1 - Euler characteristic of the lower link (T. Banchoff 1970)
    bool on_boundary = false;
    std::uint32_t node =
        kNoNode;  // of the Reeb graph, where one is given: the number of contours changes, or their parts do

    bool changes_level_set() const { return node != kNoNode; }
};

//! Critical vertices from bottom to top. A vertex is judged by its link: the neighbours below it form arcs; none is a
//! minimum, none above a maximum, several a saddle. On a boundary, neighbours form a path instead of a cycle, and
//! several arcs above count as well: an open contour is cut there. The indices sum up to the mesh's Euler characteristic,
//! with and without boundary; on a closed mesh that is minima - saddles (with multiplicity) + maxima. Isolated vertices
//! count as minima.
//! \throw InvalidInput if the field does not fit the mesh.
std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field);

//! The same, each with its node of reeb_graph(mesh, field). A critical point without one leaves the contours what they are:
//! an open one closes, a closed one opens, or a handle opens and closes at one vertex.
std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field,
                                           const ReebGraph& graph);

}  // namespace stratareeb
