// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "boreholes/point.h"
#include "subdivision/cone_integral.h"
#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! What there is over a face's part of the plan, to rounding: integrals along its edges (G. Green, 1828) of splines that are
//! integrated span by span.
struct CellIntegrals {
    double area = 0;    // in plan
    double volume = 0;  // between the face and z = 0
    ConeIntegral from_point;
};

//! \param from the point that `from_point` is measured from
CellIntegrals integrate_cell(const SmoothBrep& brep, std::uint32_t cell, const Point3& from = {});

//! Between top and base of a body.
double body_volume(const SmoothBrep& brep, const PlanCells::Body& body);

}  // namespace stratareeb
