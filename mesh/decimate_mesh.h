// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "mesh/tri_mesh.h"

namespace stratareeb {

struct DecimateOptions {
    std::optional<std::size_t> triangles;  // stop there
    //! How far the two surfaces may be apart, in the mesh's unit: from any point of one to the nearest of the other.
    std::optional<double> max_error;
    double max_turn_deg = 60;  // of a triangle's normal at one collapse
    double min_angle_deg = 5;  // triangles flatter than that are made only where there were some
    std::function<void(const char* step, double share)> progress;  // share 0..1 of the step, from one thread
};

struct DecimatedMesh {
    TriMesh mesh;  // vertices are some of the input's, in its order; vertex normals set
    std::size_t triangles_before = 0;
    //! Largest distance between the two surfaces, both ways, measured at the vertices of both and at places as dense as
    //! the input's vertices.
    double deviation = 0;
    bool target_reached = true;
    std::size_t kept_places = 0;  // around which triangles had to stay, found when the result was measured
    std::string note;             // for people
};

//! Fewer triangles for a mesh: half-edge collapses in the order of their quadric error (M. Garland and P. Heckbert 1997;
//! OpenMesh's
//! half-edges and quadrics). Components, genus and boundary loops stay; boundaries lose vertices from straight parts only. A
//! collapse that would make the surface cross itself, or lead too far off, is not done; so a watertight mesh stays
//! watertight. The result is measured anew: where it is farther off than asked between the places looked at, the input's
//! triangles are kept around there and all is done again. Deterministic.
//! \pre the mesh has no deleted elements
//! \throw InvalidInput if neither a number of triangles nor an error is given, or one is negative
DecimatedMesh decimate_mesh(const TriMesh& mesh, const DecimateOptions& options);

}  // namespace stratareeb
