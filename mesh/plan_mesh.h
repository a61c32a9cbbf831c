// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/footprint.h"
#include "mesh/pinch_lines.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! The one triangulation that all horizons share, in plan (z = 0).
struct PlanMesh {
    static constexpr std::uint32_t kNoVertex = ~0u;

    TriMesh surface;  // counter-clockwise, every vertex in a face
    std::vector<std::uint32_t>
        hole_vertex;  // the vertex of each hole, kNoVertex where it stands outside the footprint
};

struct PlanMeshOptions {
    double spacing = 0;         // longest edge wanted; 0 = the given points and lines alone
    double min_angle_deg = 20;  // quality of refined triangles, except where given lines meet at less
    //! Six vertices around each hole off lines and outline, closer to it than to anything else: room for a smooth
    //! surface to be led through the hole whatever its neighbours say.
    bool ring_holes = false;
    std::function<void(std::size_t vertices)> progress = {};
};

//! Constrained Delaunay triangulation of the footprint with the holes as vertices and the lines as edges,
//! refined to spacing and quality (J. Ruppert 1995; L. Rineau and M. Yvinec, CGAL Mesh_2).
//! \pre the footprint came from checked_footprint or one of the functions that make one.
//! \throw GeometryError if rounding folds a triangle over.
PlanMesh build_plan_mesh(const Footprint& footprint, const std::vector<Point2>& holes, const PlanLines& lines,
                         const PlanMeshOptions& options = {});

//! A spacing that gives about nine triangles a hole and no fewer than 2,500 in all: the edge of an
//! equilateral triangle.
double suitable_spacing(const Footprint& footprint, std::size_t holes);

}  // namespace stratareeb
