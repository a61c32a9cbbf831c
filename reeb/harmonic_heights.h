// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Heights in between: each vertex whose height is not given gets a weighted mean of its neighbours' (cotangent weights of the plan, none
//! below a small positive one), so that no such vertex is higher or lower than all around it. In a deep bay such heights come so close to
//! the given lowest or highest one that rounding would make them equal: within `stretched` of the whole range from either, heights run like
//! 1 / (1 - log) instead, which keeps their order and so all contours' shapes.
//! \param heights by vertex; given ones are kept, but for those within that part of the range
//! \param plan triangles of a planar region, counter-clockwise
//! \param stretched below 1/2
//! \return nothing if some vertex is joined to no given one
std::optional<std::vector<double>> harmonic_heights(const TriangleSoup& plan,
                                                    const std::vector<std::optional<double>>& heights,
                                                    double stretched = 0);

}  // namespace stratareeb
