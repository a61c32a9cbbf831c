// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_table.h"

namespace stratareeb {

//! What a column can mean. Its names in the wild are listed in table_layout.cpp.
enum class Role { X, Y, Ground, Hole, From, To, Unit, Z, Depth, HoleDepth };

//! A table with its columns named and its header found.
struct TableShape {
    const TextTable* table = nullptr;
    bool has_header = false;
    std::size_t first_row = 0;       // of data
    std::vector<std::string> names;  // one per column: as in the header, otherwise the letter A, B, …
    std::map<std::string, std::string> stated;  // role → column, from the user

    std::size_t column_count() const { return names.size(); }
    std::size_t row_count() const { return table->row_count(); }
};

//! Find the header: the first row that is not a title, if its first cells aren't numbers.
TableShape table_shape(const TextTable& table, const std::map<std::string, std::string>& stated);

//! The column of a role: as stated, otherwise by its name. Needs a header unless stated.
std::optional<std::size_t> find_column(const TableShape& shape, Role role);

//! The column that the user calls `name`: a header (letter case does not matter) or a number from 1.
std::optional<std::size_t> column_by_name(const TableShape& shape, std::string_view name);

bool is_stated(const TableShape& shape, Role role);

//! A column name in one spelling: lower case words joined by _, units of measure and brackets left out.
//! "Top Depth (m)" and "TopDepth" are both "top_depth".
std::string normal_name(std::string_view name);

//! Role names as users state them: x y ground hole from to unit z depth.
const std::vector<std::string>& stated_role_names();

}  // namespace stratareeb
