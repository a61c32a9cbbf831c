// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace stratareeb {

enum class CellKind {
    Empty,  // nothing, or a mark for it: - – ? NA N/A #N/A null none
    Number,
    AtLeast,    // ">5.2", "≥5.2", "5.2+"
    NotFinite,  // NaN, inf
    Text,
};

struct CellValue {
    CellKind kind = CellKind::Empty;
    double number = 0;
};

//! Read a cell, with a decimal point or comma, whatever the locale.
CellValue cell_value(std::string_view text, bool decimal_comma = false);

//! Without the spaces around it (no-break spaces included).
std::string_view trimmed(std::string_view text);

//! A name or code: trimmed; empty for a mark that means nothing is there; whole numbers without the ".0" or
//! exponent that a spreadsheet adds.
std::string cell_name(std::string_view text);

}  // namespace stratareeb
