// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/triangle_soup.h"
#include "reeb/cotangent_weights.h"

namespace stratareeb {

//! Where a surface bends least: places of its free vertices that make the integral of the squared Laplacian smallest, over those
//! vertices and all around them, as a thin plate does (M. Botsch and L. Kobbelt 2004). Vertices that are not free stay, and since the surface
//! beyond them counts too, it goes on there without a kink. WeightSpace::Plan: heights alone move, over the plan, where no
//! triangle around is folded over; WeightSpace::Space: all three coordinates, as the surface lies now.
//! \param is_free by vertex of a closed surface
//! \return the points, all of them; as they are if the problem has no solution
std::vector<Point3> least_bending(const TriangleSoup& soup, const std::vector<bool>& is_free,
                                  WeightSpace space);

//! The integral that is made least, over vertices that are asked for: of the squared length of the mean curvature normal, or in plan of the
//! squared Laplacian of the height.
double bending_energy(const TriangleSoup& soup, const std::vector<bool>& is_asked, WeightSpace space);

}  // namespace stratareeb
