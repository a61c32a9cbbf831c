// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "boreholes/point.h"

namespace stratareeb {

enum class SubdivisionScheme {
    Loop,          // triangles (Loop 1987)
    CatmullClark,  // quads; other polygons become quads at the first level (Catmull and Clark 1978)
};

//! A crease or corner of this sharpness, or more, stays sharp at every level. Less is semi-sharp: sharp for that many
//! levels, then smooth (DeRose, Kass, Truong 1998).
inline constexpr double kInfiniteSharpness = 10;

//! An edge along which the surface may bend.
struct Crease {
    std::uint32_t from = 0, to = 0;
    double sharpness = kInfiniteSharpness;
};

//! A vertex that stays where it is, in which a crease or an outline may turn.
struct SharpCorner {
    std::uint32_t vertex = 0;
    double sharpness = kInfiniteSharpness;
};

//! A control mesh as it is given; nothing is copied.
struct ControlMesh {
    SubdivisionScheme scheme = SubdivisionScheme::Loop;
    std::size_t vertices = 0;
    std::span<const std::uint32_t> corners;  // of face after face
    std::span<const std::uint32_t> sizes;    // corners of each face; empty = all triangles
    std::span<const Crease> creases;         // outlines are creases by themselves
    std::span<const SharpCorner> sharp_corners;
    std::span<const Point3> points;  // for messages; may be empty
};

//! "7 at (1, 2, 3)", or the number alone where there are no points.
std::string place_of(const ControlMesh& mesh, std::size_t vertex);

//! The checks that need no neighbours.
//! \throw InvalidInput naming the place: a vertex that is not there; a face that is no polygon, names a vertex twice, or is no
//! triangle where the scheme is Loop; a negative sharpness; levels below 0 or above 10; more corners than 2^31 after that many levels
void require_faces(const ControlMesh& mesh, int levels);

}  // namespace stratareeb
