// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stratareeb {

//! A column's heading (HTML), and whether its cells are numbers, which stand at its right side.
struct HtmlColumn {
    std::string heading;
    bool is_number = true;
};

//! A table of an HTML page, in a box that scrolls sideways where it is too wide. Cells are HTML.
class HtmlTable {
 public:
    explicit HtmlTable(std::vector<HtmlColumn> columns);
    void add(const std::vector<std::string>& cells);
    std::string html() const;

 private:
    std::vector<HtmlColumn> columns_;
    std::string rows_;
};

//! A number with so many significant digits, not as a power of ten, thousands parted by narrow spaces: "2 910 519".
std::string grouped_number(double value, int digits);

}  // namespace stratareeb
