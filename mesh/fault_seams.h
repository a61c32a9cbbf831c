// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! How the blocks of a faulted model meet. Each block has triangles and vertices of its own in the plan mesh; along a fault
//! the two sides have vertices at the same places. Empty without faults.
struct FaultSeams {
    std::size_t blocks = 0;
    std::vector<std::uint32_t> block;  // by plan triangle
    //! By plan vertex: the elevations of the horizons of all blocks at its place, ascending and each once; empty off faults.
    std::vector<std::vector<double>> levels;
    //! For a boundary edge on a fault, by its ends with the inside to the left: the vertices of the other side there.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<std::uint32_t, 2>> across;

    bool empty() const { return blocks == 0; }
};

//! The seams of a plan that is cut open along faults: its connected pieces are the blocks, numbered by their first triangle, and
//! where boundaries of two of them run through the same places, they meet. `horizons[k][vertex]`: elevations.
FaultSeams seams_of_pieces(const TriMesh& plan, const std::vector<std::vector<double>>& horizons);

}  // namespace stratareeb
