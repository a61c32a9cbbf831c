// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/table_context.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/cell_value.h"

namespace stratareeb {

void add_number_error(const TableShape& shape, std::size_t row, std::size_t column, TableContext& context) {
    const std::string text(shape.table->cell(row, column).substr(0, 40));
    context.audit.add_error(
        shape.table->source, shape.table->line(row), shape.names[column],
        fmt::format("\"{}\" is not a finite number; mend it, empty the cell if it is not known, or "
                    "state the columns (--columns)",
                    text));
}

std::optional<double> number_cell(const TableShape& shape, std::size_t row, std::size_t column,
                                  TableContext& context) {
    const CellValue value = cell_value(shape.table->cell(row, column), shape.table->decimal_comma);
    if (value.kind == CellKind::Empty) return std::nullopt;
    if (value.kind == CellKind::Number) return value.number;
    add_number_error(shape, row, column, context);
    return std::nullopt;
}

std::optional<double> number_cell(const TableShape& shape, std::size_t row, std::optional<std::size_t> column,
                                  TableContext& context) {
    return column ? number_cell(shape, row, *column, context) : std::nullopt;
}

CellCensus cell_census(const TableShape& shape, std::size_t column) {
    CellCensus census;
    const std::size_t last = std::min(shape.row_count(), shape.first_row + 1000);
    for (std::size_t row = shape.first_row; row < last; ++row) {
        const CellKind kind = cell_value(shape.table->cell(row, column), shape.table->decimal_comma).kind;
        if (kind == CellKind::Empty)
            ++census.empty;
        else if (kind == CellKind::Text)
            ++census.other;
        else
            ++census.numbers;
    }
    return census;
}

}  // namespace stratareeb
