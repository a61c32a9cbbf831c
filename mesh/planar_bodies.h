// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/planar_regions.h"

namespace stratareeb {

//! A connected closed surface made of planar polygons.
struct PlanarShell {
    TriMesh mesh;
    std::vector<PlanarRegion> faces;  // of `mesh`
};

//! One solid: what it fills and what is cut out of it.
struct PlanarBody {
    PlanarShell outer;
    std::vector<PlanarShell> cavities;
};

//! The bodies of a closed surface, in the order of their first triangle: connected shells that face outwards,
//! each with the inward-facing shells that lie in it (in the smallest body that holds them, where several
//! do).
//! \throw as planar_regions; GeometryError if an inward-facing shell lies in no body.
std::vector<PlanarBody> planar_bodies(const TriMesh& mesh, const PlanarRegionOptions& options = {});

}  // namespace stratareeb
