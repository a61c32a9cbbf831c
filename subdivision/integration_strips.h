// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Cut faces into strips until CAD programs, which integrate a face with a fixed number of points from side to side, come to the
//! volumes between top and base of bodies: of each body that they would get wrong by more than a share of its volume, the
//! faces that do most harm are halved, until the rest does less than half of that, or there is nothing left to halve.
//! Programs measure volumes from the middle of a solid: where neighbours are joined it is another one, and what they
//! get wrong changes. That is kept to a share of both volumes.
void cut_for_integration(SmoothBrep& brep, double share, double joined_share);

}  // namespace stratareeb
