// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boreholes/listed_layers.h"
#include "io/collars.h"
#include "io/table_context.h"

namespace stratareeb {

//! A layer's cell in every row; its unit is fixed, or stands in the cell of another column.
struct LayerColumn {
    std::optional<std::size_t> code;
    std::string unit;
    std::size_t value = 0;
};

//! Columns of a table with one row per hole.
struct WideColumns {
    std::optional<std::size_t> hole, x, y, ground;
    std::vector<LayerColumn> layers;
    std::vector<std::size_t> ignored;  // columns with something in them that is used for nothing
    TableValues values = TableValues::Thickness;
};

//! The wide columns of a table; nullopt if it is of another layout.
std::optional<WideColumns> find_wide_columns(const TableShape& shape, const ReadBoreholesOptions& options);

//! Append a table's holes.
void read_wide(const TableShape& shape, const WideColumns& columns, const CollarTable* collars,
               ListedSet& listed, TableContext& context);

}  // namespace stratareeb
