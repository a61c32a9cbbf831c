// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "io/text_table.h"

namespace stratareeb {

//! Read comma, semicolon, tab or | separated text (RFC 4180 quoting; rows of any length; LF, CRLF or CR), the
//! separator recognised from the first lines. UTF-8, UTF-16 with a byte-order mark, otherwise Windows-1252.
//! Blank lines and lines that begin with "# " are left out, line numbers count them.
//! \throw IoError if the
//! file can't be read, InvalidInput if it is no such text: NUL bytes, a cell of more than 100,000 bytes, a
//! row of more than 10,000 cells, a quote that never closes.
TextTable read_csv_table(const std::string& path);

}  // namespace stratareeb
