// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ags_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "io/cell_value.h"
#include "io/csv_table.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLongestQuote = 40;  // characters of a value shown in a message

std::string shown(std::string_view text) {
    const bool fits = text.size() <= kLongestQuote;
    return "\"" + std::string(text.substr(0, kLongestQuote)) + (fits ? "\"" : "…\"");
}

//! Rows of cells to groups. Both editions share everything but how a row says what it is.
class AgsParser {
 public:
    AgsParser(const TextTable& table, AgsFile& file, Audit& audit)
        : table_(table), file_(file), audit_(audit) {}

    void parse() {
        for (row_ = 0; row_ < table_.row_count(); ++row_) {
            if (has_line_break())
                warn(
                    "a value goes on in the next line; if that is not meant, a closing quote is missing "
                    "here");
            file_.edition == 4 ? parse_fourth() : parse_third();
        }
        for (const AgsGroup& group : file_.groups) check(group);
    }

 private:
    std::string_view cell(std::size_t column) const { return table_.cell(row_, column); }
    std::size_t line() const { return table_.line(row_); }
    void error(std::string text) { audit_.add_error(file_.source, line(), "", std::move(text)); }
    void warn(std::string text) { audit_.add_warning(file_.source, line(), "", std::move(text)); }

    bool has_line_break() const {
        for (std::size_t i = 0; i < table_.cell_count(row_); ++i)
            if (cell(i).find_first_of("\r\n") != std::string_view::npos) return true;
        return false;
    }

    std::vector<std::string> cells(std::size_t first) const {
        std::vector<std::string> result;
        for (std::size_t i = first; i < table_.cell_count(row_); ++i) result.emplace_back(cell(i));
        return result;
    }

    //! Without the empty cells that a comma at a line's end makes.
    std::vector<std::string> filled(std::size_t first) const {
        auto result = cells(first);
        while (!result.empty() && result.back().empty()) result.pop_back();
        return result;
    }

    void open(std::string_view name) {
        AgsGroup& group = file_.groups.emplace_back();
        group.name = name;
        group.line = line();
    }

    bool has_group() {
        if (!file_.groups.empty()) return true;
        error("a row before the first group; begin with the group's name");
        return false;
    }

    void add_row(std::vector<std::string> values) {
        AgsGroup& group = file_.groups.back();
        while (values.size() > group.headings.size() && values.back().empty()) values.pop_back();
        if (values.size() > group.headings.size())
            return error(fmt::format(
                "group {}: {} values under {} headings; the last is {}. Quote values with commas, or add "
                "the missing heading",
                group.name, values.size(), group.headings.size(), shown(values.back())));
        group.rows.push_back({line(), std::move(values)});
    }

    void parse_fourth() {
        const std::string_view kind = cell(0);
        if (kind.empty() && filled(0).empty()) return;
        if (kind == "GROUP") return open(cell(1));
        if (!has_group()) return;
        AgsGroup& group = file_.groups.back();
        if (kind == "HEADING")
            group.headings = filled(1);
        else if (kind == "UNIT")
            group.units = cells(1);
        else if (kind == "DATA")
            add_row(cells(1));
        else if (kind != "TYPE")
            error(fmt::format("group {}: a row begins with {}; expected GROUP, HEADING, UNIT, TYPE or DATA",
                              group.name, shown(kind)));
    }

    void parse_third() {
        const std::string_view first = cell(0);
        if (first.empty() && filled(0).empty()) return;
        if (first.starts_with("**")) return open(first.substr(first.starts_with("**?") ? 3 : 2));
        if (!has_group()) return;
        AgsGroup& group = file_.groups.back();
        if (first.starts_with("*")) return add_headings(group);
        if (first == "<UNITS>") {
            group.units = cells(0);
            group.units[0].clear();
            return;
        }
        first == "<CONT>" ? continue_row(group) : add_row(cells(0));
    }

    void add_headings(AgsGroup& group) {
        if (!group.rows.empty())
            return error(fmt::format("group {}: headings after data; begin a new group", group.name));
        for (std::string& heading : filled(0))
            group.headings.push_back(
                heading.substr(std::min(heading.find_first_not_of("*?"), heading.size())));
    }

    //! The rest of values too long for one line; of a row of units before any data.
    void continue_row(AgsGroup& group) {
        std::vector<std::string>* into = !group.rows.empty()    ? &group.rows.back().cells
                                         : !group.units.empty() ? &group.units
                                                                : nullptr;
        if (!into) return error(fmt::format("group {}: <CONT> with no row before it", group.name));
        for (std::size_t i = 1; i < table_.cell_count(row_); ++i) {
            if (cell(i).empty()) continue;
            if (i >= group.headings.size())
                return error(
                    fmt::format("group {}: {} values under {} headings in a <CONT> row; the last is {}",
                                group.name, i + 1, group.headings.size(), shown(cell(i))));
            if (into->size() <= i) into->resize(i + 1);
            (*into)[i] += cell(i);
        }
    }

    void check(const AgsGroup& group) {
        const auto say = [&](std::string text) {
            audit_.add_warning(file_.source, group.line, "", std::move(text));
        };
        if (group.headings.empty() && !group.rows.empty())
            say(fmt::format("group {} has no headings", group.name));
        for (std::size_t i = 0; i < group.headings.size(); ++i)
            if (group.column(group.headings[i]) != i)
                say(fmt::format("group {}: the heading {} stands twice; the first is used", group.name,
                                group.headings[i]));
        if (file_.all(group.name).front() != &group)
            say(fmt::format("group {} stands in the file again; all of its rows are read", group.name));
        const auto is_short = [&](const auto& row) { return row.cells.size() < group.headings.size(); };
        const auto few = std::ranges::count_if(group.rows, is_short);
        if (few > 0)
            say(
                fmt::format("group {}: {} rows have fewer values than headings, the first in line {}; the "
                            "missing ones are "
                            "taken as empty",
                            group.name, few, std::ranges::find_if(group.rows, is_short)->line));
    }

    const TextTable& table_;
    AgsFile& file_;
    Audit& audit_;
    std::size_t row_ = 0;
};

//! The first text of a file, without byte-order mark, quotes and blank space before it.
std::string first_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(256, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        std::erase(text, '\0'), text.erase(0, 2);
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text;
}

bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}

}  // namespace

std::optional<std::size_t> AgsGroup::column(std::string_view heading) const {
    const auto found = std::ranges::find(headings, heading);
    if (found == headings.end()) return std::nullopt;
    return static_cast<std::size_t>(found - headings.begin());
}

std::string_view AgsGroup::cell(const Row& row, std::optional<std::size_t> column) const {
    return column && *column < row.cells.size() ? trimmed(row.cells[*column]) : std::string_view();
}

std::string_view AgsGroup::unit(std::size_t column) const {
    return column < units.size() ? trimmed(units[column]) : std::string_view();
}

std::vector<const AgsGroup*> AgsFile::all(std::string_view name) const {
    std::vector<const AgsGroup*> result;
    for (const AgsGroup& group : groups)
        if (group.name == name) result.push_back(&group);
    return result;
}

bool is_ags_file(const std::string& path) {
    std::string text = first_text(path);
    std::erase(text, '"');
    if (text.starts_with("**")) return text.size() > 2 && (is_upper(text[2]) || text[2] == '?');
    return text.starts_with("GROUP,") && text.size() > 6 && is_upper(text[6]);
}

AgsFile read_ags_file(const std::string& path, Audit& audit) {
    AgsFile file;
    file.source = path;
    const std::string text = first_text(path);
    file.edition = text.starts_with("\"**") || text.starts_with("**") ? 3 : 4;
    const TextTable table = read_csv_table(path);
    AgsParser(table, file, audit).parse();
    return file;
}

}  // namespace stratareeb
