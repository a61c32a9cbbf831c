// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/layer_regions.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! What a level set does to a plan mesh.
struct LevelLine {
    std::span<const double> value;                     // per vertex; the line is where it is 0
    std::size_t layer = 0;                             // only through triangles that have this layer
    std::span<const char> fixed;                       // per vertex: not to be moved
    std::function<void(const VertexMean&)> on_vertex;  // for each vertex moved or made, before the next one
};

//! Make the zero set of a function that is linear over the triangles a chain of edges. Vertices within a fifth of an edge's
//! length from it are moved there along the edge where the triangles around stay sound; other edges are cut.
//! `in_face` grows with the mesh.
//! \return the vertices moved or made, which are on the line
std::vector<std::uint32_t> insert_level_line(TriMesh& mesh, std::vector<LayerSet>& in_face,
                                             const LevelLine& line);

}  // namespace stratareeb
