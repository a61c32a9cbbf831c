// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stratareeb {

//! Write a MeshLab project (.mlp) that opens a list of meshes at once, one layer each: name and file,
//! relative to the project.
//! \throw IoError if it can't be written
void write_meshlab_project(const std::filesystem::path& file,
                           const std::vector<std::pair<std::string, std::string>>& name_and_relative_file);

}  // namespace stratareeb
