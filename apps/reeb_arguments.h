// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stratareeb {

//! What the command `reeb` was given.
struct ReebArguments {
    std::vector<std::string> meshes;
    std::string output, colored, loops, field = "z";
    std::optional<double> simplify;
    bool enhanced = false;
    std::size_t levels = 20;
    double tolerance = 0;
    bool plateaus = false, pairs = false, repair = false, overwrite = false, json = false;
};

}  // namespace stratareeb
