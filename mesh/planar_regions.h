// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! A planar polygon made of neighbouring triangles that lie in one plane.
struct PlanarRegion {
    Point3 point;   // of the plane
    Point3 normal;  // unit length, on the outer side
    //! Mesh vertex indices, outer loop first and counter-clockwise seen from outside, holes clockwise. Simple
    //! closed loops without a repeated vertex, at least three vertices each.
    std::vector<std::vector<std::uint32_t>> loops;
    std::size_t triangles = 0;
};

struct PlanarRegionOptions {
    //! How far a vertex may be from the plane of its region, and a vertex on a straight side from that side,
    //! as a fraction of the bounding box's diagonal. The default admits rounding and nothing else.
    double tolerance = 1e-11;
    //! Leave out vertices where just two regions meet along a straight line.
    bool drop_straight_vertices = true;
};

//! Merge coplanar neighbouring triangles of a closed surface into planar polygons, large triangles first.
//! A region whose border would touch itself is cut into regions without holes. Two regions that meet along a
//! side use the same vertices there. \pre The mesh has no deleted elements (garbage is collected).
//! \throw InvalidInput if the surface is open, GeometryError at a triangle without area; both name the place.
std::vector<PlanarRegion> planar_regions(const TriMesh& mesh, const PlanarRegionOptions& options = {});

}  // namespace stratareeb
