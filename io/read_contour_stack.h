// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reeb/contour_stack.h"

namespace stratareeb {

struct ReadContourStackOptions {
    std::string
        elevation;  // attribute or column of the height; none = recognised by its name, or the points' own z
    std::string
        part;  // of several bodies in one file, the one to read: the value in the column roi, body, part, …
    bool leave_out_open = false;  // lines that don't close; they are faults otherwise
};

//! Read closed contours with their heights, in any order and sense. By the file's name and content:
//! - .json: {"contours": [{"z": 1, "points": [[x, y], …]}, …]}, as `levels` writes it; other keys are passed over;
//! - text tables and spreadsheets of points: columns x, y, elevation, the contour they belong to (ring, contour, line, …; none =
//!   one contour a height) and their place in it (vertex, order, …; none = as they come);
//! - whatever else OGR opens (GeoJSON, GeoPackage, shapefiles, DXF, tables with a column of well-known text): lines and polygons, holes
//!   included, with the height as an attribute or as their points' z.
//! Whether they are simple and apart is sorted_stack's question.
//! \throw IoError if the file can't be opened; InvalidInput with all faults, each with its feature, row or place, or if there is no
//! contour.
ContourStack read_contour_stack(const std::string& file, const ReadContourStackOptions& options = {});

}  // namespace stratareeb
