// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/volume_mesh.h"

namespace stratareeb {

//! A face of a cell by the cell's own corners (0 … 5), counter-clockwise seen from outside.
struct CellFace {
    std::uint8_t corners = 3;  // 3 or 4
    std::array<std::uint8_t, 4> corner{};
};

std::span<const CellFace> faces_of(CellKind kind);

//! Where a face of the mesh's outer surface lies.
enum class BoundarySide : std::uint8_t { Ground, Base, Side };

//! A face that belongs to a single cell.
struct BoundaryFace {
    BoundarySide side = BoundarySide::Side;
    std::uint8_t corners = 3;
    std::array<std::uint32_t, 4> node{};  // counter-clockwise seen from outside
    std::uint32_t cell = 0;
};

//! The outer surface of a mesh, or of one of its layers, in the order of cells.
//! \throw GeometryError if a face belongs to more than two cells, or two cells lie on the same side of one.
std::vector<BoundaryFace> boundary_faces(const VolumeMesh& mesh);
std::vector<BoundaryFace> boundary_faces(const VolumeMesh& mesh, std::size_t layer);

}  // namespace stratareeb
