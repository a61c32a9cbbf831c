// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! A place beside each vertex of a plan mesh, as weights of the corners of a triangle at that vertex.
struct MovedPlaces {
    std::vector<std::array<std::uint32_t, 3>> corner;
    std::vector<std::array<double, 3>> weight;

    //! Values there of the function that is linear over each triangle.
    std::vector<double> values(const std::vector<double>& at_vertices) const;
};

//! Where vertices have moved to, (x, y) by vertex. A place beyond all triangles at its vertex is seen from the one
//! closest to it.
MovedPlaces moved_places(const TriMesh& mesh, const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stratareeb
