// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

enum class CriticalType { Minimum, Saddle, Maximum };

//! A vertex at which the level set through it differs from those just below and above in the number of its pieces.
struct CriticalPoint {
    std::uint32_t vertex = 0;
    double value = 0;
    CriticalType type = CriticalType::Minimum;
    int multiplicity = 1;  // of a saddle: 1 simple, 2 for a monkey saddle
    int index = 1;         // 1 - Euler characteristic of the lower link (T. Banchoff 1970)
    bool on_boundary = false;
};

//! Critical vertices from bottom to top. A vertex is judged by its link: the neighbours below it form arcs; none is a
//! minimum, none above a maximum, several a saddle. On a boundary, neighbours form a path instead of a cycle, and
//! several arcs above count as well: an open contour is cut there. The indices sum up to the mesh's Euler characteristic,
//! with and without boundary; on a closed mesh that is minima - saddles (with multiplicity) + maxima. Vertices whose only
//! change is an open contour that closes, or a closed one that opens, are not listed. Isolated vertices count as minima.
//! \throw InvalidInput if the field does not fit the mesh.
std::vector<CriticalPoint> critical_points(const TriMesh& mesh, const ScalarField& field);

}  // namespace stratareeb
