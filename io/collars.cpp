// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/collars.h"

#include <fmt/format.h>

#include "io/cell_value.h"

namespace stratareeb {
namespace {

struct CollarColumns {
    std::optional<std::size_t> hole, x, y, ground;
};

CollarColumns collar_columns(const TableShape& shape) {
    if (!shape.has_header && shape.stated.empty() && shape.column_count() >= 3)
        return {0, 1, 2, shape.column_count() > 3 ? std::optional<std::size_t>(3) : std::nullopt};
    return {find_column(shape, Role::Hole), find_column(shape, Role::X), find_column(shape, Role::Y),
            find_column(shape, Role::Ground)};
}

bool is_new_hole(CollarTable& table, const Collar& collar, TableContext& context) {
    const Collar* other = table.find(collar.id);
    if (!other) return true;
    context.audit.add_warning(table.file, collar.row, "",
                              fmt::format("hole {} stands in row {} already{}; that row is used", collar.id,
                                          other->row, other->at == collar.at ? "" : ", at another place"));
    return false;
}

void add_row(const TableShape& shape, const CollarColumns& columns, std::size_t row, CollarTable& table,
             TableContext& context) {
    Collar collar;
    collar.id = cell_name(shape.table->cell(row, *columns.hole));
    collar.row = shape.table->line(row);
    const std::size_t errors = context.audit.error_count();
    const auto x = number_cell(shape, row, *columns.x, context),
               y = number_cell(shape, row, *columns.y, context);
    collar.ground = number_cell(shape, row, columns.ground, context);
    if (context.audit.error_count() > errors) return;
    if (collar.ground) *collar.ground *= context.vertical;
    if (collar.id.empty() && !x && !y) return;
    if (collar.id.empty() || !x || !y) {
        context.audit.add_warning(table.file, collar.row, "",
                                  collar.id.empty()
                                      ? "no hole id; the row is left out"
                                      : fmt::format("hole {} has no x, y; it is left out", collar.id));
        if (!collar.id.empty()) table.dropped.emplace(collar.id, collar.row);
        return;
    }
    collar.at = {*x, *y};
    if (!is_new_hole(table, collar, context)) return;
    table.by_id.emplace(collar.id, table.collars.size());
    table.collars.push_back(std::move(collar));
}

}  // namespace

bool is_collar_table(const TableShape& shape) {
    const CollarColumns columns = collar_columns(shape);
    return shape.has_header && columns.hole && columns.x && columns.y &&
           !(find_column(shape, Role::From) && find_column(shape, Role::To));
}

CollarTable read_collars(const TableShape& shape, TableContext& context) {
    const CollarColumns columns = collar_columns(shape);
    CollarTable table;
    table.file = shape.table->source;
    if (!columns.hole || !columns.x || !columns.y) {
        context.audit.add_error(
            table.file, 0, "",
            "no columns for hole, x and y found in the collar table; state them, for example "
            "--columns hole=ID,x=Easting,y=Northing");
        return table;
    }
    for (std::size_t row = shape.first_row; row < shape.row_count(); ++row)
        add_row(shape, columns, row, table, context);
    return table;
}

}  // namespace stratareeb
