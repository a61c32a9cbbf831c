// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/vertex_order.h"

namespace stratareeb {

//! A vertex that contours may not simply pass: its neighbours below, or those above, form no fan or several.
struct CriticalLink {
    std::uint32_t vertex = 0;
    std::uint32_t first_fan = 0, fans = 0;  // lower fans, in VertexDescent::fan_below
    std::uint32_t strands = 0;              // upper fans
    // Of a vertex on the boundary: its neighbours on the boundary below it and above it, two together. So many contours end
    // at it just below and just above.
    std::uint8_t ends_below = 0, ends_above = 0;
    bool is_on_boundary() const { return ends_below + ends_above > 0; }
};

//! From each vertex one step down, by ranks (places in the order): to its highest lower neighbour. At a critical vertex there
//! is one step for each lower fan. The contour just below a vertex crosses the edges of these steps.
struct VertexDescent {
    static constexpr std::uint32_t kCritical = 0x80000000u;  // | index of the critical link

    std::vector<std::uint32_t> below;      // by rank: a rank, or kCritical | index
    std::vector<std::uint32_t> fan_below;  // ranks
    std::vector<CriticalLink> critical;    // in the order of their vertices
    bool has_boundary = false;

    bool is_critical(std::uint32_t rank) const { return below[rank] & kCritical; }
    const CriticalLink& critical_at(std::uint32_t rank) const { return critical[below[rank] & ~kCritical]; }
};

//! One pass over the mesh, on all threads.
VertexDescent vertex_descent(const TriMesh& mesh, const VertexOrder& order);

}  // namespace stratareeb
