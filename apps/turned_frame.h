// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"
#include "reeb/plane_frame.h"

namespace stratareeb {

//! The frame whose w is a direction: the shortest rotation that turns it upward; what points down is turned over about the x axis
//! first, so that no denominator comes near 0.
//! \throw InvalidInput if the direction has no length
PlaneFrame upward_frame(const Point3& direction);

//! Into a frame's coordinates, where its w is up.
void turn_into(TriMesh& mesh, const PlaneFrame& frame);

//! From a frame's coordinates back to those it is given in.
void turn_back(TriangleSoup& soup, const PlaneFrame& frame);

}  // namespace stratareeb
