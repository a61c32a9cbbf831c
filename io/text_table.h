// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stratareeb {

//! Rows of text cells as a file has them; rows may have different lengths. All text lies in one buffer, so
//! that millions of cells are cheap.
class TextTable {
 public:
    std::string source;          // as the user named it, for messages
    std::string sheet;           // of a workbook or database; empty for text files
    bool decimal_comma = false;  // 12,5 is twelve and a half
    bool has_geometry = false;   // columns 0 and 1 are x and y of a point layer, not from the table itself
    std::string crs;             // of that geometry, as WKT; empty if none is stated
    std::vector<std::string>
        field_names;  // where the source knows its columns by name (databases); else empty

    void add_cell(std::string_view text) {
        text_.append(text);
        cell_end_.push_back(text_.size());
    }
    //! End the row of the cells added since the last call; `line` is its 1-based place in the file.
    void end_row(std::size_t line) {
        row_end_.push_back(cell_end_.size());
        lines_.push_back(line);
    }

    std::size_t row_count() const { return row_end_.size(); }
    std::size_t cell_count(std::size_t row) const { return row_end_[row] - first_cell(row); }
    std::size_t line(std::size_t row) const { return lines_[row]; }

    //! Empty where the row is shorter.
    std::string_view cell(std::size_t row, std::size_t column) const {
        if (column >= cell_count(row)) return {};
        const std::size_t i = first_cell(row) + column;
        const std::size_t begin = i == 0 ? 0 : cell_end_[i - 1];
        return std::string_view(text_).substr(begin, cell_end_[i] - begin);
    }

    //! Cells of the longest row.
    std::size_t column_count() const {
        std::size_t longest = 0;
        for (std::size_t row = 0; row < row_count(); ++row) longest = std::max(longest, cell_count(row));
        return longest;
    }

 private:
    std::size_t first_cell(std::size_t row) const { return row == 0 ? 0 : row_end_[row - 1]; }

    std::string text_;
    std::vector<std::size_t> cell_end_, row_end_, lines_;
};

}  // namespace stratareeb
