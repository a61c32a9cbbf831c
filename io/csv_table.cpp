// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv_table.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "boreholes/errors.h"
#include "io/cell_value.h"

namespace stratareeb {
namespace {

constexpr std::size_t kLongestCell = 100000;  // bytes
constexpr std::size_t kMostCells = 10000;     // in a row
constexpr std::size_t kProbedLines = 50;      // for the separator

std::string file_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw IoError(path + ": can't be opened for reading");
    const auto size = file.tellg();
    if (size < 0) throw IoError(path + ": can't be read");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.seekg(0);
    file.read(bytes.data(), size);
    if (!file) throw IoError(path + ": can't be read to its end");
    return bytes;
}

void append_utf8(std::string& out, std::uint32_t c) {
    const auto put = [&](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
    if (c < 0x80) return put(c);
    if (c < 0x800) {
        put(0xc0 | (c >> 6));
    } else {
        if (c < 0x10000) {
            put(0xe0 | (c >> 12));
        } else {
            put(0xf0 | (c >> 18));
            put(0x80 | ((c >> 12) & 0x3f));
        }
        put(0x80 | ((c >> 6) & 0x3f));
    }
    put(0x80 | (c & 0x3f));
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
    std::string out;
    std::uint32_t high = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const auto a = static_cast<unsigned char>(bytes[i]), b = static_cast<unsigned char>(bytes[i + 1]);
        const std::uint32_t c = big_endian ? (a << 8U) | b : (b << 8U) | a;
        if (c >= 0xd800 && c < 0xdc00) {
            high = c;
        } else if (c >= 0xdc00 && c < 0xe000) {
            append_utf8(out, high ? 0x10000 + ((high - 0xd800) << 10) + (c - 0xdc00) : 0xfffd);
            high = 0;
        } else {
            append_utf8(out, c);
        }
    }
    return out;
}

bool is_utf8(std::string_view bytes) {
    for (std::size_t i = 0; i < bytes.size();) {
        const auto c = static_cast<unsigned char>(bytes[i]);
        const std::size_t length = c < 0x80         ? 1
                                   : (c >> 5) == 6  ? 2
                                   : (c >> 4) == 14 ? 3
                                   : (c >> 3) == 30 ? 4
                                                    : 0;
        if (length == 0 || i + length > bytes.size()) return false;
        for (std::size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(bytes[i + k]) >> 6) != 2) return false;
        i += length;
    }
    return true;
}

// Windows-1252 differs from Latin-1 in 0x80 … 0x9f.
constexpr std::array<std::uint16_t, 32> kWindows1252{
    0x20ac, 0x81,   0x201a, 0x192,  0x201e, 0x2026, 0x2020, 0x2021, 0x2c6,  0x2030, 0x160,
    0x2039, 0x152,  0x8d,   0x17d,  0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x2dc,  0x2122, 0x161,  0x203a, 0x153,  0x9d,   0x17e,  0x178};

std::string from_windows_1252(std::string_view bytes) {
    std::string out;
    for (const char byte : bytes) {
        const auto c = static_cast<unsigned char>(byte);
        append_utf8(out, c >= 0x80 && c < 0xa0 ? kWindows1252[c - 0x80U] : c);
    }
    return out;
}

std::string utf8_text(std::string bytes, const std::string& path) {
    if (bytes.starts_with("\xff\xfe")) return from_utf16(std::string_view(bytes).substr(2), false);
    if (bytes.starts_with("\xfe\xff")) return from_utf16(std::string_view(bytes).substr(2), true);
    if (const auto nul = bytes.find('\0'); nul != bytes.npos)
        throw InvalidInput(fmt::format("{}: a NUL byte at byte {}: not a text table", path, nul + 1));
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
    return is_utf8(bytes) ? bytes : from_windows_1252(bytes);
}

//! The separator that the first lines have most of, outside quotes; tab and ; count before a comma, which may
//! be decimal.
char separator_of(std::string_view text) {
    constexpr std::string_view kCandidates = "\t;|,";
    std::array<std::size_t, 4> lines_with{};
    std::array<bool, 4> seen{};
    std::size_t lines = 0;
    bool quoted = false, any = false;
    for (std::size_t i = 0; i <= text.size() && lines < kProbedLines; ++i) {
        const char c = i < text.size() ? text[i] : '\n';
        if (c == '"') quoted = !quoted;
        if (quoted && i < text.size()) continue;
        if (const auto k = kCandidates.find(c); k != kCandidates.npos) seen[k] = true;
        any = any || (c != '\n' && c != '\r');
        if (c != '\n' && c != '\r') continue;
        for (std::size_t k = 0; k < 4; ++k) lines_with[k] += seen[k];
        lines += any;
        seen = {};
        any = false;
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (lines > 0 && 2 * lines_with[k] > lines) return kCandidates[k];
    return ',';
}

class CsvParser {
 public:
    CsvParser(std::string_view text, char separator, TextTable& table)
        : text_(text), separator_(separator), table_(table) {}

    void parse() {
        while (at_ < text_.size()) parse_row();
    }

 private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InvalidInput(fmt::format("{}:{}: {}", table_.source, line_, what));
    }

    bool at_line_end() const { return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }

    //! "# …", "## …" or a bare "#"; "#12" may be a hole and "#x" a header.
    bool is_comment() const {
        if (text_[at_] != '#') return false;
        return at_ + 1 >= text_.size() ||
               std::string_view("# \t\r\n").find(text_[at_ + 1]) != std::string_view::npos;
    }

    void skip_line_end() {
        if (at_ >= text_.size()) return;
        if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
        ++at_;
        ++line_;
    }

    void parse_row() {
        const std::size_t line = line_;
        if (at_line_end()) return skip_line_end();
        if (is_comment()) {
            while (!at_line_end()) ++at_;
            return skip_line_end();
        }
        std::size_t cells = 0;
        for (;;) {
            if (++cells > kMostCells)
                fail(fmt::format("more than {} cells in a row: not a borehole table", kMostCells));
            parse_cell();
            if (at_line_end()) break;
            ++at_;  // the separator
        }
        table_.end_row(line);
        skip_line_end();
    }

    void parse_cell() {
        std::size_t start = at_;
        while (start < text_.size() && text_[start] == ' ' && separator_ != ' ') ++start;
        if (start < text_.size() && text_[start] == '"') {
            at_ = start + 1;
            return parse_quoted();
        }
        const std::size_t begin = at_;
        while (!at_line_end() && text_[at_] != separator_)
            if (++at_ - begin > kLongestCell) fail_long();
        table_.add_cell(trimmed(text_.substr(begin, at_ - begin)));
    }

    void parse_quoted() {
        std::string cell;
        const std::size_t line = line_;
        for (;;) {
            if (at_ >= text_.size()) fail(fmt::format("the quote that opens in line {} never closes", line));
            const char c = text_[at_++];
            if (c == '\n' || (c == '\r' && (at_ >= text_.size() || text_[at_] != '\n'))) ++line_;
            if (c == '"') {
                if (at_ >= text_.size() || text_[at_] != '"') break;
                ++at_;
            }
            cell.push_back(c);
            if (cell.size() > kLongestCell) fail_long();
        }
        while (!at_line_end() && text_[at_] != separator_)
            cell.push_back(text_[at_++]);  // "a"b: keep what is there
        if (cell.size() > kLongestCell) fail_long();
        table_.add_cell(trimmed(cell));
    }

    [[noreturn]] void fail_long() const {
        fail(fmt::format("a cell of more than {} bytes: not a borehole table, or an open quote",
                         kLongestCell));
    }

    std::string_view text_;
    char separator_;
    TextTable& table_;
    std::size_t at_ = 0, line_ = 1;
};

enum class Mark { None, Point, Comma, CommaBeforeThree };

Mark decimal_mark(std::string_view cell) {
    std::size_t i = cell.starts_with('-') || cell.starts_with('+') ? 1 : 0;
    const std::size_t first = i;
    while (i < cell.size() && cell[i] >= '0' && cell[i] <= '9') ++i;
    if (i == first || i + 1 >= cell.size() || (cell[i] != '.' && cell[i] != ',')) return Mark::None;
    const char mark = cell[i];
    const std::size_t fraction = cell.size() - i - 1;
    if (cell.find_first_not_of("0123456789", i + 1) != cell.npos) return Mark::None;
    if (mark == '.') return Mark::Point;
    return fraction == 3 && cell[first] != '0' ? Mark::CommaBeforeThree : Mark::Comma;
}

//! Commas are decimal if no number has a point, and (where commas also part the cells) one can't be a
//! thousands mark.
bool has_decimal_comma(const TextTable& table, char separator) {
    bool comma = false, thousands = false;
    for (std::size_t row = 0; row < table.row_count(); ++row)
        for (std::size_t column = 0; column < table.cell_count(row); ++column) {
            const Mark mark = decimal_mark(table.cell(row, column));
            if (mark == Mark::Point) return false;
            comma = comma || mark == Mark::Comma;
            thousands = thousands || mark == Mark::CommaBeforeThree;
        }
    return comma || (thousands && separator != ',');
}

}  // namespace

TextTable read_csv_table(const std::string& path) {
    const std::string text = utf8_text(file_bytes(path), path);
    TextTable table;
    table.source = path;
    const char separator = separator_of(text);
    CsvParser(text, separator, table).parse();
    table.decimal_comma = has_decimal_comma(table, separator);
    return table;
}

}  // namespace stratareeb
