// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/input_mesh.h"
#include "boreholes/point.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! `--field x|y|z|dx,dy,dz|distance:X,Y,Z|file:PATH|property:NAME`, the same in every command that asks for a field.
void add_field_option(CLI::App& command, std::string& field);

//! The field of such a text: values from a file or property go with the vertices that the mesh's own come from.
//! \throw InvalidInput, IoError if the values can't be read or are not one finite number a vertex
ScalarField field_of(const InputMesh& input, const std::string& field);

//! The direction if the field is height along one.
std::optional<Point3> field_direction(const std::string& field);

}  // namespace stratareeb
