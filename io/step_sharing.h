// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string_view>

namespace stratareeb {

//! Write a STEP file (ISO 10303-21) in which points, directions, vectors, lines and B-splines that say the same are there once:
//! neighbours write each its own. Nothing but their numbers tells them apart, so no solid changes. What is left is numbered
//! from 1 on in the order of the file.
//! \param text a whole file with one data section and no comments
//! \throws InvalidInput if it is none, or refers to an entity that is not in it
void share_step_geometry(std::string_view text, std::ostream& stream);

}  // namespace stratareeb
