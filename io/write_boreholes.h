// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "boreholes/borehole.h"
#include "io/read_boreholes.h"

namespace stratareeb {

//! Write a survey as a table that `read_boreholes` reads back, as CSV or, by extension, XLSX. In CSV, numbers
//! have the digits that give the same double again; XLSX keeps 15 digits, as spreadsheets do. A file that is
//! there is replaced once the new one is whole.
//! Wide (and Auto): hole_id, x, y, ground and a thickness column for each unit; empty = unknown, ">5" = at
//! least
//! 5. A layer with nothing known below it reads back as "at least": the hole is taken to end in it.
//! Intervals: hole_id, from, to, unit down to the first unknown cell, and collars (hole_id, x, y, ground) in
//! `collar_table(file)`. The last interval of a log reads back as "at least" too.
//! Points: x, y, z, unit for the top of each layer, "base" for the base of the lowest, where the hole knows
//! it.
//! \throw IoError if the extension is unknown or a file can't be written; InvalidInput for the layout
//! Samples, or if a hole without a ground is to be written as intervals.
void write_boreholes(const std::filesystem::path& file, const Survey& survey,
                     TableLayout layout = TableLayout::Wide);

//! The collars beside an interval table: wells.csv has wells_collars.csv.
std::filesystem::path collar_table(const std::filesystem::path& file);

}  // namespace stratareeb
