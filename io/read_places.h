// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A place that somebody asks about, in map coordinates.
struct Place {
    std::string id;  // empty if the table has no such column
    Point2 at;
    std::optional<double> z;
};

//! Read places from any table that read_tables opens, its first sheet: columns x and y (or easting and northing, …), and
//! if there are any z (or elevation) and id (or name). A cell of z may be empty.
//! \throw IoError; InvalidInput naming all rows (up to 200) whose x, y or z is no number, or the columns that are there if
//! x or y is not among them.
std::vector<Place> read_places(const std::string& source);

}  // namespace stratareeb
