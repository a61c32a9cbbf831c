// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Triangles made fit for a half-edge mesh, and what was done to them.
struct OrientedSoup {
    TriangleSoup soup;
    std::vector<std::uint32_t>
        source_point;            // of each point, its number in the input; copies follow at the end
    std::size_t degenerate = 0;  // triangles dropped that named a vertex twice
    std::size_t duplicate = 0;   // triangles dropped that had the corners of an earlier one
    std::size_t turned = 0;      // triangles wound the other way round than before
    std::size_t copies = 0;      // of points, where surfaces were cut apart

    bool is_changed() const { return degenerate + duplicate + turned + copies > 0; }
};

//! Cut, turn and drop triangles until half_edge_mesh takes them. Surfaces are cut apart along edges of more than two triangles
//! and in vertices of more than one fan, each piece getting a copy of the points; pieces are wound alike, as most of their
//! triangles were; a piece that has one side only, like a Moebius strip, is cut across. Points are neither moved nor welded:
//! layers that touch stay apart. Sound triangles come back as they are. (CGAL's orient_polygon_soup does the same, but walks depth
//! first, so that its cuts through one-sided pieces are spirals: 238 points of a strip that nine points part.)
//! \throw InvalidInput if a triangle names a vertex that is not there
OrientedSoup orient_soup(const TriangleSoup& soup);

}  // namespace stratareeb
