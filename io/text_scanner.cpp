// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// For messages: junk from a binary file must not reach a terminal, nor a whole file the message.
std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 40)) text += c >= 32 && c < 127 ? c : '?';
    return word.size() > 40 ? text + "…" : text;
}

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
    return word;
}

}  // namespace

std::string file_content(const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
        throw IoError(fmt::format("{}: is a folder; give the name of a file", file.string()));
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw IoError(fmt::format("{}: can't be opened; does it exist, may it be read?", file.string()));
    std::string content;
    const auto size = std::filesystem::file_size(file, error);
    if (!error) content.reserve(size);
    std::string block(1 << 20, '\0');
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0)
        content.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) throw IoError(fmt::format("{}: can't be read", file.string()));
    return content;
}

std::string_view TextScanner::word() {
    std::size_t begin = 0;
    while (begin < rest_.size() && is_blank(rest_[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest_.size() && rest_[end] != '\n' && !is_blank(rest_[end])) ++end;
    const auto found = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return found;
}

std::string_view TextScanner::word_anywhere() {
    auto found = word();
    while (found.empty() && !rest_.empty()) {
        next_line();
        found = word();
    }
    return found;
}

std::string_view TextScanner::rest_of_line() {
    const auto end = rest_.find('\n');
    auto found = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (end != std::string_view::npos) ++line_;
    while (!found.empty() && is_blank(found.front())) found.remove_prefix(1);
    while (!found.empty() && is_blank(found.back())) found.remove_suffix(1);
    return found;
}

double TextScanner::number(std::string_view text) const {
    const auto digits = without_plus(text);
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = stop == digits.data() + digits.size();
    const bool tiny = error == std::errc::result_out_of_range &&
                      digits.find_first_of("eE") != std::string_view::npos &&
                      digits[digits.find_first_of("eE") + 1] == '-';
    if (whole && tiny) return 0;
    if (text.empty()) fail("a number is missing");
    if (error != std::errc{} || !whole || !std::isfinite(value))
        fail(fmt::format("'{}' is not a finite number", shown(text)));
    return value;
}

long long TextScanner::integer(std::string_view text) const {
    const auto digits = without_plus(text);
    long long value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (text.empty()) fail("a whole number is missing");
    if (error != std::errc{} || stop != digits.data() + digits.size())
        fail(fmt::format("'{}' is not a whole number", shown(text)));
    return value;
}

void TextScanner::fail(const std::string& message) const {
    throw InvalidInput(fmt::format("{}:{}: {}", file_, line_, message));
}

}  // namespace stratareeb
