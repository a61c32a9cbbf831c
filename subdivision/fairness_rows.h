// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/tri_mesh.h"
#include "subdivision/control_topology.h"

namespace stratareeb {

//! Fairness rows and the vertex that each is about.
struct FairnessRows {
    SparseRows rows;
    std::vector<std::size_t> vertex;
};

//! For each inner vertex, how far its value is from the mean of its neighbours', all alike: a fair
//! parametrisation of the plan.
FairnessRows umbrella_rows(const TriMesh& mesh);

//! The same with cotangent weights in the plane of (x, y), divided by the sum of their magnitudes, and second differences
//! along the rim where it is straight: 0 for every field that is linear in x and y, whatever the triangles.
FairnessRows bending_rows(const TriMesh& mesh, const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stratareeb
