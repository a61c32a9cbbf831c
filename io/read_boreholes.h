// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"
#include "boreholes/contact_points.h"
#include "boreholes/stratigraphy.h"

namespace stratareeb {

enum class TableLayout {
    Auto,
    Wide,       // one row a hole: x, y, ground, then code and thickness pairs, or one column per layer
    Intervals,  // one row an interval: hole, from, to, unit; with a collar table, or x, y and ground in each
                // row
    Points,     // one row a contact: x, y, z, unit; or hole, depth, unit with a collar table
    Samples,    // one row a sample at a regular spacing: hole, x, y, elevation, unit
};

//! What the numbers of layers are. Auto: as column names say, otherwise thicknesses (wide), depths
//! (intervals) and elevations (points).
enum class TableValues { Auto, Thickness, Depth, Elevation };

struct ReadBoreholesOptions {
    TableLayout layout = TableLayout::Auto;
    TableValues values = TableValues::Auto;
    std::string collars;  // table of hole, x, y and ground; empty = not needed or in `sources`
    std::map<std::string, std::string>
        columns;                     // role → column by name, or by number (1 = first); roles: x y ground
                                     // hole from to unit z depth; an empty name = no such column
    std::vector<std::string> order;  // unit codes from top to bottom; empty = listed or inferred order
    RepeatRule repeats = RepeatRule::Absorb;    // for a unit that comes back lower down in a hole
    std::string length_unit = "m";              // of the whole table: m, ft or us-ft; kept as it is
    std::string vertical_unit;                  // of elevations, depths and thicknesses if another; converted
    PointsMark points_mark = PointsMark::Auto;  // whether contacts are tops or bases of their units
    bool has_ground_raster = false;             // the ground will come from a raster
    bool keep_far_holes = false;                // keep holes absurdly far from all others
};

struct BoreholeTable {
    Survey survey;
    Audit audit;  // warnings only: errors throw
    TableLayout layout = TableLayout::Auto;
    TableValues values = TableValues::Auto;
    std::string crs;  // of the places, as WKT, where a layer of points states one; else empty
};

//! Read boreholes from tables of one layout: text, spreadsheet, GeoPackage or any other source that OGR
//! opens, each "FILE" or "FILE:SHEET". Layout and columns are recognised unless stated. docs/boreholes.md
//! says what is understood and what is done about faults in the data.
//! \throw InvalidInput with every row that
//! can't be used; IoError if a source can't be opened.
BoreholeTable read_boreholes(const std::vector<std::string>& sources,
                             const ReadBoreholesOptions& options = {});

}  // namespace stratareeb
