// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_places.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "boreholes/audit.h"
#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/read_table.h"
#include "io/table_layout.h"

namespace stratareeb {

namespace {

using Column = std::optional<std::size_t>;

//! No role of a borehole table, but what lists of places call them.
Column name_column(const TableShape& shape) {
    for (const std::string_view name : {"id", "name", "point", "well"})
        for (std::size_t i = 0; i < shape.column_count(); ++i)
            if (normal_name(shape.names[i]) == name) return i;
    return find_column(shape, Role::Hole);
}

class PlaceReader {
 public:
    explicit PlaceReader(const TextTable& table)
        : table_(table),
          shape_(table_shape(table, {})),
          x_(needed(Role::X, "x")),
          y_(needed(Role::Y, "y")),
          z_(find_column(shape_, Role::Z)),
          id_(name_column(shape_)) {}

    std::vector<Place> read() {
        std::vector<Place> places;
        places.reserve(table_.row_count());
        for (std::size_t row = shape_.first_row; row < table_.row_count(); ++row) {
            Place place;
            if (id_) place.id = cell_name(table_.cell(row, *id_));
            place.at.x = number(row, x_, true).value_or(0);
            place.at.y = number(row, y_, true).value_or(0);
            if (z_) place.z = number(row, *z_, false);
            places.push_back(std::move(place));
        }
        audit_.throw_if_errors();
        if (places.empty()) throw InvalidInput(table_.source + ": no rows of places");
        return places;
    }

 private:
    std::size_t needed(Role role, std::string_view name) const {
        if (const auto column = find_column(shape_, role)) return *column;
        throw InvalidInput(fmt::format("{}: there is no column {}; the columns are {}", table_.source, name,
                                       fmt::join(shape_.names, ", ")));
    }

    std::optional<double> number(std::size_t row, std::size_t column, bool needed) {
        const std::string_view text = table_.cell(row, column);
        const CellValue value = cell_value(text, table_.decimal_comma);
        if (value.kind == CellKind::Number) return value.number;
        if (value.kind == CellKind::Empty && !needed) return std::nullopt;
        audit_.add_error(table_.source, table_.line(row), shape_.names[column],
                         value.kind == CellKind::Empty
                             ? "is empty (expected a number)"
                             : fmt::format("\"{}\" is no number", text.substr(0, 40)));
        return std::nullopt;
    }

    const TextTable& table_;
    TableShape shape_;
    std::size_t x_, y_;
    Column z_, id_;
    Audit audit_;
};

}  // namespace

std::vector<Place> read_places(const std::string& source) {
    const std::vector<TextTable> tables = read_tables(source);
    return PlaceReader(tables.front()).read();
}

}  // namespace stratareeb
