// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "io/read_contour_stack.h"

namespace stratareeb {

//! The lines and rings of polygons of any OGR source, as read_contour_stack says. Arcs become polylines, collections their parts.
ContourStack read_contour_features(const std::string& file, const ReadContourStackOptions& options);

}  // namespace stratareeb
