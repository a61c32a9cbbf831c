// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stratareeb {

enum class Severity {
    Warning,  // worked around; the text says how
    Error,    // can't be used
};

//! One thing that is wrong with a table, and where.
struct Finding {
    Severity severity = Severity::Warning;
    std::string file;
    std::size_t row = 0;  // 1-based line (text) or row (spreadsheet, database); 0 = no single row
    std::string column;   // as the header names it, or its letter; empty = no single column
    std::string text;
};

//! All that was found wrong while a table was read, in the order of discovery, so that a user mends
//! everything in one go. Keeps the first 10,000 findings of each severity and counts the rest.
class Audit {
 public:
    void add_warning(std::string file, std::size_t row, std::string column, std::string text);
    void add_error(std::string file, std::size_t row, std::string column, std::string text);

    const std::vector<Finding>& findings() const { return findings_; }
    std::size_t error_count() const { return errors_; }
    std::size_t warning_count() const { return warnings_; }
    bool has_errors() const { return errors_ > 0; }

    //! One line per finding, `file:row: column X: text`; at most `limit` lines and then the number left out.
    std::string text(std::size_t limit = 200) const;

    //! \throw InvalidInput with all errors (200 of them, then the number left out); warnings never throw.
    void throw_if_errors() const;

 private:
    void add(Finding finding);

    std::vector<Finding> findings_;
    std::size_t errors_ = 0, warnings_ = 0;
};

//! `file:row: column X: text`, leaving out what is not known.
std::string finding_line(const Finding& finding);

}  // namespace stratareeb
