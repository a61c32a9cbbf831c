// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/layer_volumes.h"

namespace stratareeb {

//! Read a truth as `sample` writes it: {"box": [x0, y0, x1, y1], "units": [{"code", "volume"}, …]}.
//! \throw IoError if the file can't be read, InvalidInput with the place of what is wrong in it
TrueVolumes read_true_volumes(const std::string& file);

}  // namespace stratareeb
