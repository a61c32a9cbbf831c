// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "boreholes/plan_box.h"
#include "mesh/tri_mesh.h"
#include "subdivision/height_patch.h"

namespace stratareeb {

//! Of a triangle of the plan.
PlanBox box_of(const TriMesh& plan, std::uint32_t face);

//! A triangle of a body's part of the plan.
struct ThicknessSample {
    std::uint32_t face;
    double thickness;        // its mean
    const HeightPatch* top;  // that lies over it
};

//! Limits of the coefficients of a body's base that keep it below its top and a share of the thickness away. A spline is
//! between the least and the largest of its coefficients, so where those of the base lie below the top's in the same
//! knots, the sheets don't cross, also between samples. Functions that reach over the body's end have no limit (infinity):
//! the base is to go through the top there. Nor have those under tops whose breaks are not all in x and y. Over functions
//! that several tops share, each counts no deeper than it is above its own triangles: beyond them it may run off steeply, and
//! the base would be pulled down from the other ones with it. Samples have to keep the sheets apart there.
//! \param ends places where the thickness is 0 since the body ends.
//! \param share of the least mean thickness of a triangle that a function reaches.
std::vector<double> limits_below_top(const CubicKnots& x, const CubicKnots& y, const TriMesh& plan,
                                     const std::vector<ThicknessSample>& samples,
                                     const std::vector<HeightSample>& ends, double share);

}  // namespace stratareeb
