// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "subdivision/smooth_brep.h"

class TopoDS_Shape;

namespace stratareeb {

//! The bodies as OpenCASCADE solids [brep.cells.bodies]. Neighbours have the face between them in common.
std::vector<std::shared_ptr<const TopoDS_Shape>> smooth_shapes(const SmoothBrep& brep);

}  // namespace stratareeb
