// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/reeb_arguments.h"

namespace stratareeb {

//! `reeb MESH --enhanced`: the enhanced Reeb graph of a mesh over height along a direction, written and reported. Where
//! that is not z, the mesh is turned so that it is.
//! \pre arguments.field is a direction
//! \throw InvalidInput, IoError
void run_enhanced_reeb(const ReebArguments& arguments);

}  // namespace stratareeb
