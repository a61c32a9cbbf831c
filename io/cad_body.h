// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "io/mesh_part.h"

class TopoDS_Shape;

namespace stratareeb {

//! One solid for CAD: an OpenCASCADE solid with a name and a colour.
struct CadBody {
    std::string name;
    Rgb color{200, 200, 200};
    std::shared_ptr<const TopoDS_Shape> solid;
};

//! "clay" for a unit's first body, "clay, body 2" for the next.
std::string body_name(const Unit& unit, std::size_t body);

std::size_t count_faces(const TopoDS_Shape& shape);

//! Enclosed volume as OpenCASCADE integrates it.
double cad_volume(const TopoDS_Shape& shape);

}  // namespace stratareeb
