// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boreholes/audit.h"

namespace stratareeb {

//! One group of an AGS file: a small table of its own.
struct AgsGroup {
    struct Row {
        std::size_t line = 0;  // where it begins in the file
        std::vector<std::string> cells;
    };

    std::string name;      // GEOL, LOCA, …
    std::size_t line = 0;  // of its name
    std::vector<std::string> headings, units;
    std::vector<Row> rows;

    std::optional<std::size_t> column(std::string_view heading) const;
    //! Empty where the row is shorter or has no such column.
    std::string_view cell(const Row& row, std::optional<std::size_t> column) const;
    //! "m" as the UNIT row says; empty if it says nothing.
    std::string_view unit(std::size_t column) const;
};

//! A file of ground investigation data as the Association of Geotechnical and Geoenvironmental Specialists defines it
//! (AGS 3.1, 2005; AGS 4.1, 2020).
struct AgsFile {
    std::string source;  // as the user named it, for messages
    int edition = 4;     // 3 or 4
    std::vector<AgsGroup> groups;

    //! All groups of a name; a sound file has one.
    std::vector<const AgsGroup*> all(std::string_view name) const;
};

//! Does the file begin as AGS files do: "GROUP","… (edition 4) or "**… (edition 3)? False for what can't be read.
bool is_ags_file(const std::string& path);

//! Read all groups. Edition 3: headings over several lines, <UNITS> and <CONT> rows, user-defined names with a question
//! mark. Edition 4: GROUP, HEADING, UNIT, TYPE and DATA rows. LF or CRLF; UTF-8 with or without byte-order mark, UTF-16,
//! otherwise Windows-1252. What breaks the rules is an error (values without a heading) or a warning (the rest).
//! \throw IoError if the file can't be read, InvalidInput if it is no text
AgsFile read_ags_file(const std::string& path, Audit& audit);

}  // namespace stratareeb
