// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/reeb_arguments.h"

namespace stratareeb {

//! `reeb MESH MESH…`: the layered Reeb graph of several meshes over the same field, written and reported.
//! \throw InvalidInput, IoError as reading, fields and writing do
void run_layered_reeb(const ReebArguments& arguments);

}  // namespace stratareeb
