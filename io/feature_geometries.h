// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

class OGRGeometry;

namespace stratareeb {

//! Call `visit` for the geometry of every feature of all layers of a file that OGR reads, curves as lines of short pieces.
//! \param content what the file should hold, for the message: "polygons"
//! \throw IoError if the file can't be opened
void for_each_geometry(const std::string& path, const std::string& content,
                       const std::function<void(OGRGeometry&)>& visit);

}  // namespace stratareeb
