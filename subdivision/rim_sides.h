// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! A part of the plan's rim that carries one wall.
struct RimSide {
    std::vector<std::uint32_t> vertices;  // the plan's inside on the left
    bool straight = false;                // to rounding; otherwise a curve through or near the vertices
};

struct RimSidesOptions {
    std::size_t most_sides = 40;  // more corners than that are rounded off where they turn little
    double soft_corner_deg = 25;
};

//! Cut the plan's rim, ring by ring, into sides: from corner to corner, or, where there are too many corners,
//! from sharp corner to sharp corner. Each ring has at least two sides.
std::vector<RimSide> rim_sides(const TriMesh& plan, const RimSidesOptions& options = {});

//! Directions change by how much at b on the way from a over b to c, in degrees, 0..180.
double turning_deg(const TriMesh& plan, std::uint32_t a, std::uint32_t b, std::uint32_t c);

}  // namespace stratareeb
