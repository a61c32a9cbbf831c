// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace stratareeb {

//! One value a vertex from a text file: a number a line, in the order of the mesh's vertices. The first line may be a header;
//! empty lines at the end don't count. A decimal comma is understood.
//! \throw IoError if the file can't be read; InvalidInput listing all lines that are no finite number (the first twenty of
//! them), or if there are not `count` values
std::vector<double> read_field(const std::filesystem::path& file, std::size_t count);

}  // namespace stratareeb
