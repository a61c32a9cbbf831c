// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace stratareeb {

//! \throw IoError if there is a file of that name and `overwrite` is false.
void keep_existing(const std::filesystem::path& file, bool overwrite);

}  // namespace stratareeb
