// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cell_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace stratareeb {
namespace {

constexpr std::array<std::string_view, 10> kNothing{"-",    "\xe2\x80\x93", "?",    "na",   "n/a",
                                                    "#n/a", "null",         "none", "<na>", "\xe2\x80\x94"};
constexpr std::string_view kNoBreakSpace = "\xc2\xa0", kMinus = "\xe2\x88\x92", kAtLeast = "\xe2\x89\xa5";

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

bool means_nothing(std::string_view text) {
    if (text.empty()) return true;
    return text.size() <= 4 && std::find(kNothing.begin(), kNothing.end(), lower(text)) != kNothing.end();
}

std::optional<double> plain_number(std::string_view text, bool decimal_comma) {
    std::string buffer;
    if (text.starts_with(kMinus)) {
        buffer = '-' + std::string(text.substr(kMinus.size()));
        text = buffer;
    }
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
    if (decimal_comma && std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == text.npos) {
        buffer = text;
        std::replace(buffer.begin(), buffer.end(), ',', '.');
        text = buffer;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return text.find('-', 1) != text.npos ? 0.0 : HUGE_VAL;
    if (error != std::errc()) return std::nullopt;
    return value;
}

std::optional<std::string_view> at_least_text(std::string_view text) {
    if (text.starts_with(kAtLeast)) return trimmed(text.substr(kAtLeast.size()));
    if (text.starts_with(">=")) return trimmed(text.substr(2));
    if (text.starts_with('>')) return trimmed(text.substr(1));
    if (text.ends_with('+')) return trimmed(text.substr(0, text.size() - 1));
    return std::nullopt;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    for (;;) {
        if (!text.empty() && is_space(text.front()))
            text.remove_prefix(1);
        else if (!text.empty() && is_space(text.back()))
            text.remove_suffix(1);
        else if (text.starts_with(kNoBreakSpace))
            text.remove_prefix(kNoBreakSpace.size());
        else if (text.ends_with(kNoBreakSpace))
            text.remove_suffix(kNoBreakSpace.size());
        else
            return text;
    }
}

CellValue cell_value(std::string_view text, bool decimal_comma) {
    text = trimmed(text);
    if (means_nothing(text)) return {};
    CellKind kind = CellKind::Number;
    std::optional<double> value = plain_number(text, decimal_comma);
    if (!value) {
        const auto bound = at_least_text(text);
        if (bound) value = plain_number(*bound, decimal_comma);
        kind = CellKind::AtLeast;
    }
    if (!value) return {CellKind::Text, 0};
    return {std::isfinite(*value) ? kind : CellKind::NotFinite, *value};
}

std::string cell_name(std::string_view text) {
    text = trimmed(text);
    if (means_nothing(text)) return {};
    if (text.find_first_of(".eE") != text.npos && text.find_first_not_of("0123456789.eE+-") == text.npos) {
        const auto value = plain_number(text, false);
        if (value && std::abs(*value) < 9e15 && *value == std::round(*value))
            return fmt::format("{:.0f}", *value);
    }
    return std::string(text);
}

}  // namespace stratareeb
