// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/text_table.h"

namespace stratareeb {

//! Read all tables of a source as text cells: a text file (.csv .tsv .txt .dat .xyz),
//! or whatever OGR opens: every sheet of an XLSX, XLS or ODS workbook, every layer of a GeoPackage, a
//! shapefile, or a connection string such as "PG:…". `file.xlsx:Sheet` names one sheet or layer. Row numbers
//! are those of the file. A layer of points without columns of its own for x and y gets them from its
//! geometry.
//! \throw IoError if the source can't be opened or has no table; InvalidInput if it is no sensible
//! table.
std::vector<TextTable> read_tables(const std::string& source);

}  // namespace stratareeb
