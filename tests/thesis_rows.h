// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of Tables 4.2 to 4.4 of the thesis (tests/thesis/README.md).
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "boreholes/point.h"
#include "io/csv_table.h"

namespace stratareeb::thesis {

struct HeldOutRow {
    Point2 at;
    std::size_t draw = 0;                   // from 1
    std::vector<double> actual, estimated;  // per layer: depth 1, depth 2
};

inline double number(const TextTable& table, std::size_t row, std::size_t column) {
    return std::strtod(std::string(table.cell(row, column)).c_str(), nullptr);
}

//! Sample 1, 2 or 3: Table 4.2, 4.3 or 4.4.
inline std::vector<HeldOutRow> rows_of(int sample) {
    const TextTable table =
        read_csv_table(STRATAREEB_SOURCE_DIR "/tests/thesis/table_4_" + std::to_string(sample + 1) + ".csv");
    std::vector<HeldOutRow> rows;
    for (std::size_t r = 1; r < table.row_count(); ++r) {
        HeldOutRow& row = rows.emplace_back();
        row.at = {number(table, r, 1), number(table, r, 2)};
        const std::size_t last = table.cell_count(r) - 1;
        row.draw = static_cast<std::size_t>(number(table, r, last));
        for (std::size_t column = 3; column + 1 < last; column += 2) {
            row.actual.push_back(number(table, r, column));
            row.estimated.push_back(number(table, r, column + 1));
        }
    }
    return rows;
}

}  // namespace stratareeb::thesis
