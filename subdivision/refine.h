// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/polygon_mesh.h"
#include "mesh/tri_mesh.h"
#include "subdivision/control_mesh.h"

namespace stratareeb {

//! What becomes of the outlines of an open mesh.
enum class BoundaryRule {
    Smooth,        // smooth curves all around
    SharpCorners,  // smooth curves between corners, which stay where they are
    Fixed,         // outlines stay exactly as they are; edges are cut, not bent
};

struct RefineOptions {
    SubdivisionScheme scheme = SubdivisionScheme::Loop;
    int levels = 2;  // each makes four faces of one; Catmull-Clark's first makes n quads of an n-gon
    BoundaryRule boundary = BoundaryRule::SharpCorners;
    double corner_angle_deg = 50;  // SharpCorners: an outline that turns by more has a corner there
    std::optional<double>
        crease_angle_deg;  // edges whose faces' normals differ by more stay sharp; none = no such edges
    std::vector<Crease> creases;  // and these
    std::vector<SharpCorner> sharp_corners;
    bool limit = true;  // put vertices where infinitely many levels would, with the normals there
};

struct RefinedMesh {
    PolygonMesh mesh;  // control vertices come first; triangles (Loop) or quads
    std::vector<Point3>
        normals;  // of the limit surface; of adjacent faces, averaged, on creases. Empty unless limit
    std::size_t creases = 0;  // edges of the control mesh, outlines not counted
    std::size_t corners = 0;  // vertices of the control mesh
};

//! Subdivide a mesh by OpenSubdiv. Vertices without faces stay.
//! \throw InvalidInput naming the place, as ControlTopology does
RefinedMesh refine(const PolygonMesh& control, const RefineOptions& options = {});

//! The same from and to half-edge triangles; quads are cut at their shorter diagonals. Vertex normals are the limit's or zero.
TriMesh refine(const TriMesh& control, const RefineOptions& options = {});

}  // namespace stratareeb
