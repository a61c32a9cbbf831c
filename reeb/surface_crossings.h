// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/self_intersection.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! The same as self_intersections, faster for surfaces between contours: their triangles are long along contours and low, and lie in
//! layers of height. Heights are stretched by a power of two, which changes no answer, until triangles are about as high as wide.
SelfIntersections surface_crossings(const TriangleSoup& soup, std::size_t named);

}  // namespace stratareeb
