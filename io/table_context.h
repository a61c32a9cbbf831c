// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "boreholes/audit.h"
#include "io/read_boreholes.h"
#include "io/table_layout.h"

namespace stratareeb {

//! What all table readers share: the options and where findings go.
struct TableContext {
    const ReadBoreholesOptions& options;
    Audit& audit;
    double vertical = 1;  // length units per vertical unit
};

//! The number in a cell; nullopt where it is empty. Text and infinite numbers are errors. "At least" marks
//! too.
std::optional<double> number_cell(const TableShape& shape, std::size_t row, std::size_t column,
                                  TableContext& context);
std::optional<double> number_cell(const TableShape& shape, std::size_t row, std::optional<std::size_t> column,
                                  TableContext& context);

//! Add the error that a cell holds no number.
void add_number_error(const TableShape& shape, std::size_t row, std::size_t column, TableContext& context);

//! How many of the first 1,000 data rows have a number (or nothing) in this column, and how many something
//! else.
struct CellCensus {
    std::size_t empty = 0, numbers = 0, other = 0;
};
CellCensus cell_census(const TableShape& shape, std::size_t column);

}  // namespace stratareeb
