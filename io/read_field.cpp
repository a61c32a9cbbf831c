// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_field.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/text_scanner.h"

namespace stratareeb {

namespace {

constexpr std::size_t kListedLines = 20;  // of those that are wrong; more would not be read
constexpr std::size_t kShownText = 40;    // of such a line, in bytes

std::vector<std::string_view> lines_of(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // the mark of UTF-8
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        lines.push_back(trimmed(text.substr(0, end)));
        if (end == text.npos) break;
        text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
    }
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

std::string_view unquoted(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
}

std::string complaint(std::string_view line) {
    if (line.empty()) return "is empty (expected one number)";
    std::string shown(line.substr(0, kShownText));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 32) c = ' ';
    if (line.size() > kShownText) shown += "...";
    const bool is_number = cell_value(unquoted(line)).kind == CellKind::NotFinite;
    return fmt::format("{} is {} (expected one number)", shown,
                       is_number                                  ? "not finite"
                       : line.find_first_of(",;\t ") == line.npos ? "no number"
                                                                  : "not one number");
}

}  // namespace

std::vector<double> read_field(const std::filesystem::path& file, std::size_t count) {
    const std::string content = file_content(file);
    const std::vector<std::string_view> lines = lines_of(content);
    std::vector<double> values;
    values.reserve(lines.size());
    std::string wrong;
    std::size_t wrong_lines = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const CellValue value = cell_value(unquoted(lines[i]), true);
        if (i == 0 && value.kind == CellKind::Text) continue;  // the header
        values.push_back(value.number);
        if (value.kind == CellKind::Number || ++wrong_lines > kListedLines) continue;
        wrong +=
            fmt::format("{}{}:{}: {}", wrong.empty() ? "" : "\n", file.string(), i + 1, complaint(lines[i]));
    }
    if (wrong_lines > kListedLines)
        wrong += fmt::format("\n{}: and {} lines more", file.string(), wrong_lines - kListedLines);
    if (!wrong.empty()) throw InvalidInput(wrong);
    if (values.size() != count)
        throw InvalidInput(fmt::format("{}: {} values for a mesh of {} vertices (expected one a vertex)",
                                       file.string(), values.size(), count));
    return values;
}

}  // namespace stratareeb
