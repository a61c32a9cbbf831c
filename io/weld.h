// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Make one vertex of all whose coordinates are exactly equal (-0 equals 0); they are numbered as they first
//! appear.
void weld(TriangleSoup& soup);

}  // namespace stratareeb
