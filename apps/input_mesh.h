// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb {

//! A mesh file as a half-edge mesh, and which of the file's vertices each of its own comes from.
struct InputMesh {
    std::string file;
    TriMesh mesh;
    std::vector<std::uint32_t> file_vertex;  // of each vertex; empty = the same number
    std::size_t file_vertices = 0;           // in the file
};

//! `--repair`, the same in every command that needs an oriented 2-manifold.
void add_repair_option(CLI::App& command, bool& repair);

//! Read a mesh; if it is to be repaired, say on standard error what was changed.
//! \throw InvalidInput with the file's name and place where it is no oriented 2-manifold and not to be repaired
InputMesh read_input_mesh(const std::string& file, bool repair = false);

}  // namespace stratareeb
