// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/polygon_mesh.h"
#include "subdivision/control_topology.h"

namespace stratareeb {

//! One face of a level, and the vertices that cut it into its children in the next.
struct TreeFace {
    std::span<const std::uint32_t> corners;
    std::vector<std::uint32_t> middles;  // middle i is between corners i and i + 1
    std::uint32_t centre = 0;            // Catmull-Clark only
    std::size_t first_child = 0;         // of as many as there are corners, and one more (Loop)
};

//! The faces of all levels of a refined mesh as trees. Vertices have the same numbers in all levels.
class FaceTree {
 public:
    FaceTree(const ControlTopology& topology, const PolygonMesh& control, SubdivisionScheme scheme);

    int levels() const { return static_cast<int>(corners_.size()) - 1; }
    std::size_t face_count(int level) const;
    std::size_t child_count(int level, std::size_t face) const;
    std::span<const std::uint32_t> corners(int level, std::size_t face) const;
    //! \pre level < levels(); `face` is filled anew, so that one serves for many
    void open(int level, std::size_t face, TreeFace& opened) const;

 private:
    SubdivisionScheme scheme_;
    std::size_t size_;                                 // of faces from level 1 on
    std::vector<std::size_t> first_;                   // of control faces among their corners
    std::vector<std::vector<std::uint32_t>> corners_;  // by level
};

}  // namespace stratareeb
