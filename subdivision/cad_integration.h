// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/cone_integral.h"
#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! What CAD programs add to what a face is to add to a volume (CellIntegrals) by mistake.
struct IntegrationError {
    ConeIntegral across;              // along x, from the face's lowest x to its edges
    std::vector<ConeIntegral> along;  // each edge, in the order of the loops

    ConeIntegral all() const;
};

//! OpenCASCADE integrates along each edge, and along x from the face's lowest x to the edge, with at most 61 points of Gauss,
//! whatever the spans between (BRepGProp_Face, BRepGProp_Gauss of version 7.6).
IntegrationError integration_error(const SmoothBrep& brep, std::uint32_t cell, const Point3& from);

//! The same of a wall, which is exact across: each edge of its loop.
std::vector<ConeIntegral> wall_integration_error(const SmoothBrep& brep, const PlanCells::Wall& wall,
                                                 const Point3& from);

}  // namespace stratareeb
