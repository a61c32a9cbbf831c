// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "subdivision/control_mesh.h"

namespace stratareeb {

//! Edges and vertices of a mesh that stay sharp when it is subdivided.
struct CreaseList {
    std::vector<Crease> creases;
    std::vector<SharpCorner> corners;
};

//! Read a list of creases: text, one entry a line, words parted by blanks or commas; vertices are numbered from 0.
//!
//!     12 57              an edge, sharp at every level
//!     12 57 2.5          sharp for two and a half levels, then smooth
//!     line 12 57 58 60   edges one after another
//!     corner 12          a vertex that stays where it is; also with a sharpness
//!     feature pinch-out  what follows belongs to this feature
//!
//! A # begins a comment. A first line that begins with "from", a table's head, is passed over.
//! \param features names of the features to take; empty = the whole list
//! \throw IoError if the file can't be read; InvalidInput naming the line, or the features that are there if one is not
CreaseList read_creases(const std::filesystem::path& file, const std::vector<std::string>& features = {});

}  // namespace stratareeb
