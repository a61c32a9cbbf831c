// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/audit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(Audit, line_names_file_row_and_column) {
    EXPECT_EQ(finding_line({Severity::Error, "a.csv", 3, "x", "bad"}), "a.csv:3: column x: bad");
    EXPECT_EQ(finding_line({Severity::Warning, "a.csv", 0, "", "odd"}), "a.csv: odd");
    EXPECT_EQ(finding_line({Severity::Warning, "", 0, "", "odd"}), "odd");
}

TEST(Audit, warnings_do_not_throw) {
    Audit audit;
    audit.add_warning("a.csv", 1, "", "odd");
    EXPECT_NO_THROW(audit.throw_if_errors());
    EXPECT_EQ(audit.text(), "a.csv:1: odd\n");
}

TEST(Audit, throws_all_errors_at_once_and_no_warning) {
    Audit audit;
    audit.add_warning("a.csv", 1, "", "odd");
    audit.add_error("a.csv", 2, "x", "bad");
    audit.add_error("a.csv", 9, "", "worse");
    try {
        audit.throw_if_errors();
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_STREQ(error.what(), "a.csv:2: column x: bad\na.csv:9: worse");
    }
}

TEST(Audit, long_lists_are_cut_and_counted) {
    Audit audit;
    for (std::size_t i = 1; i <= 20000; ++i) audit.add_error("a.csv", i, "", "bad");
    EXPECT_EQ(audit.error_count(), 20000u);
    EXPECT_EQ(audit.findings().size(), 10000u);
    try {
        audit.throw_if_errors();
        FAIL();
    } catch (const InvalidInput& error) {
        const std::string text = error.what();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 200);
        EXPECT_NE(text.find("and 19800 more"), std::string::npos);
    }
}

}  // namespace
}  // namespace stratareeb
