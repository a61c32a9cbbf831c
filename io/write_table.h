// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace stratareeb {

//! Empty, a number or text.
using OutputCell = std::variant<std::monostate, double, std::string>;

struct OutputTable {
    std::vector<std::string> columns;
    std::vector<std::vector<OutputCell>> rows;  // as long as `columns`
};

//! Write a table with a header row as .csv (RFC 4180, UTF-8, decimal point) or .xlsx. A file that is there is
//! replaced once the new one is whole.
//! \throw IoError if the extension is another or the file can't be
//! written.
void write_table(const std::filesystem::path& file, const OutputTable& table);

}  // namespace stratareeb
