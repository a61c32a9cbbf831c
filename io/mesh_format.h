// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace stratareeb {

enum class MeshFormat { Ply, Obj, Stl, Off, Glb, ThreeMf };

//! The format that a file's extension stands for, in upper or lower case.
//! \throw IoError naming the known ones if it stands for none
MeshFormat mesh_format(const std::filesystem::path& file);

//! Does the extension stand for a mesh format?
bool is_mesh_file(const std::filesystem::path& file);

}  // namespace stratareeb
