// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! One value a vertex, linear over each triangle.
using ScalarField = std::vector<double>;

//! Height along a direction: the dot product with it, z for (0, 0, 1). The direction need not be of unit length.
//! \throw InvalidInput if the direction is zero or not finite.
ScalarField height_field(const TriMesh& mesh, const Point3& direction = {0, 0, 1});

//! Straight distance from a place.
ScalarField distance_field(const TriMesh& mesh, const Point3& from);

//! The one order of vertices that everything here uses: by value, equal values by vertex index (simulation of
//! simplicity, H. Edelsbrunner and E. Mücke 1990), so that plateaus and ties need no cases of their own.
inline bool is_below(const ScalarField& field, std::uint32_t a, std::uint32_t b) {
    return field[a] < field[b] || (field[a] == field[b] && a < b);
}

//! \throw InvalidInput if the field has not one finite value a vertex.
void check_field(const TriMesh& mesh, const ScalarField& field);

}  // namespace stratareeb
