// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "boreholes/hole_log.h"
#include "io/collars.h"
#include "io/table_context.h"

namespace stratareeb {

//! Columns of a table with one row per interval.
struct IntervalColumns {
    std::size_t hole = 0, from = 0, to = 0, unit = 0;
    std::optional<std::size_t> x, y, ground;  // where the table holds the collars itself
    bool elevations = false;                  // from and to are elevations
};

//! The interval columns of a table; nullopt if it is of another layout.
std::optional<IntervalColumns> find_interval_columns(const TableShape& shape, TableValues values);

//! Append a table's intervals to `logs`. Holes come from `collars`, otherwise from the table's own x, y and
//! ground. Holes without intervals stay in, with what is known of their ground.
void read_intervals(const TableShape& shape, const IntervalColumns& columns, const CollarTable* collars,
                    LogSet& logs, TableContext& context);

}  // namespace stratareeb
