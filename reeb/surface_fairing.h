// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>

#include "mesh/triangle_soup.h"
#include "reeb/band_surface.h"

namespace stratareeb {

//! Make a closed surface smooth where it is free: each free vertex goes to where the surface bends least (see least_bending), or
//! only part of the way where all of it would make another minimum, maximum or saddle. All that is not free
//! stays, and what each vertex is to its height (see link_signs), so that the Reeb graph over height stays too.
//! \param rigid groups that stay
void fair_surface(TriangleSoup& soup, const FreeVertices& free, const std::set<std::uint32_t>& rigid);

}  // namespace stratareeb
