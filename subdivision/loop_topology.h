// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! Triangles and edges of one level of a one-to-four refined triangulation. Of a level's vertices, those of the level
//! before come first, then one for each of its edges.
struct LoopLevel {
    static constexpr std::uint32_t kNone = ~0u;

    std::size_t vertices = 0;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // children of triangle f: 4 f … 4 f + 3
    std::vector<std::array<std::uint32_t, 2>> ends;       // of each edge; children of edge e: 2 e and 2 e + 1
    std::vector<std::array<std::uint32_t, 2>> across;     // corners facing an edge; kNone beyond the rim
    std::vector<std::uint32_t> valence;                   // edges at each vertex

    bool is_rim(std::size_t edge) const { return across[edge][1] == kNone; }
};

//! The levels of uniform refinement, for any number of fields that live on them.
class LoopTopology {
 public:
    //! Level 0 has the numbering of the mesh: vertices, edges and faces.
    LoopTopology(const TriMesh& mesh, int levels);

    int levels() const { return static_cast<int>(levels_.size()) - 1; }
    const LoopLevel& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }
    const LoopLevel& finest() const { return levels_.back(); }

 private:
    std::vector<LoopLevel> levels_;
};

}  // namespace stratareeb
