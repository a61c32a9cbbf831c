// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_body.h"

#include <fmt/format.h>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

namespace stratareeb {

std::string body_name(const Unit& unit, std::size_t body) {
    const std::string name = unit.name.empty() ? unit.code : unit.name;
    return body == 0 ? name : fmt::format("{}, body {}", name, body + 1);
}

std::size_t count_faces(const TopoDS_Shape& shape) {
    std::size_t count = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) ++count;
    return count;
}

double cad_volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

}  // namespace stratareeb
