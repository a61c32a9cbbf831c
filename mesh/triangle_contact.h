// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Exact yes-or-no questions about the triangles of one soup: floating-point filters first, exact numbers in
//! doubt.
class TriangleContact {
 public:
    explicit TriangleContact(const TriangleSoup& soup) : soup_(soup) {}

    //! No area: a vertex named twice, or three corners on one line.
    bool is_degenerate(std::uint32_t triangle) const;

    //! Do two triangles meet anywhere but in the vertices and edges that they share by index? Corners that
    //! coincide without sharing an index count as meeting; so do copies of one triangle.
    //! \pre neither is
    //! degenerate
    bool meet(std::uint32_t a, std::uint32_t b) const;

 private:
    const TriangleSoup& soup_;
};

}  // namespace stratareeb
