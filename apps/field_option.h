// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! `--field x|y|z|dx,dy,dz`, the same in every command that asks for a field.
void add_field_option(CLI::App& command, std::string& field);

//! The height field of such a text.
ScalarField field_of(const TriMesh& mesh, const std::string& field);

//! A mesh file as a half-edge mesh. \throw InvalidInput with the file's name where it is no oriented 2-manifold.
TriMesh half_edge_mesh_of(const std::string& file);

//! \throw IoError if there is a file of that name and `overwrite` is false.
void keep_existing(const std::filesystem::path& file, bool overwrite);

}  // namespace stratareeb
