// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/html_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {

HtmlTable::HtmlTable(std::vector<HtmlColumn> columns) : columns_(std::move(columns)) {}

void HtmlTable::add(const std::vector<std::string>& cells) {
    rows_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        rows_ +=
            fmt::format("<td{}>{}</td>",
                        i < columns_.size() && columns_[i].is_number ? " class=\"number\"" : "", cells[i]);
    rows_ += "</tr>\n";
}

std::string HtmlTable::html() const {
    std::string heads;
    for (const HtmlColumn& column : columns_)
        heads += fmt::format("<th{}>{}</th>", column.is_number ? " class=\"number\"" : "", column.heading);
    return fmt::format(
        "<div class=\"wide\"><table><thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n", heads,
        rows_);
}

std::string grouped_number(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    const double size = std::abs(value);
    const int whole = size < 1 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
    std::string text = size != 0 && size < 1e-4 ? fmt::format("{:.{}g}", value, digits)
                                                : fmt::format("{:.{}f}", value, std::max(0, digits - whole));
    std::size_t point = std::min(text.find('.'), text.size());
    const std::size_t first = value < 0 ? 1 : 0;
    constexpr std::size_t kGroup = 3;
    if (point - first <= kGroup + 1 || text.find('e') != std::string::npos)
        return text;  // 9999 is clear as it is
    for (; point > first + kGroup; point -= kGroup) text.insert(point - kGroup, "\u202f");
    return text;
}

}  // namespace stratareeb
