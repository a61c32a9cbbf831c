// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cell_value.h"

#include <gtest/gtest.h>

#include <clocale>

namespace stratareeb {
namespace {

void expect_number(const char* text, double number, bool comma = false) {
    const CellValue value = cell_value(text, comma);
    EXPECT_EQ(value.kind, CellKind::Number) << text;
    EXPECT_EQ(value.number, number) << text;
}

TEST(CellValue, reads_numbers) {
    expect_number("0", 0);
    expect_number(" -1.5 ", -1.5);
    expect_number("+2", 2);
    expect_number("1e3", 1000);
    expect_number(
        "\xc2\xa0"
        "7\xc2\xa0",
        7);
    expect_number(
        "\xe2\x88\x92"
        "3.5",
        -3.5);
    expect_number("2,5", 2.5, true);
    expect_number("1e-400", 0);
}

TEST(CellValue, number_does_not_depend_on_the_locale) {
    if (!std::setlocale(LC_NUMERIC, "de_DE.UTF-8")) GTEST_SKIP() << "no German locale here";
    expect_number("1.5", 1.5);
    std::setlocale(LC_NUMERIC, "C");
}

TEST(CellValue, marks_for_nothing_are_empty) {
    for (const char* text : {"", "  ", "-", "\xe2\x80\x93", "?", "NA", "n/a", "#N/A", "NULL", "none"})
        EXPECT_EQ(cell_value(text).kind, CellKind::Empty) << text;
}

TEST(CellValue, lower_bounds) {
    const std::string at_least_sign = "\xe2\x89\xa5";
    for (const std::string& text : {std::string(">5.2"), std::string("> 5.2"), std::string(">=5.2"),
                                    at_least_sign + "5.2", std::string("5.2+"), std::string("5.2 +")}) {
        EXPECT_EQ(cell_value(text).kind, CellKind::AtLeast) << text;
        EXPECT_EQ(cell_value(text).number, 5.2) << text;
    }
}

TEST(CellValue, other_text_is_no_number) {
    for (const char* text : {"abc", "1.2.3", "1,5", "12 m", "0x10", "1e", "--1", "<3", "+", ">", "1 234"})
        EXPECT_EQ(cell_value(text).kind, CellKind::Text) << text;
    for (const char* text : {"nan", "NaN", "inf", "-inf", "1e999"})
        EXPECT_EQ(cell_value(text).kind, CellKind::NotFinite) << text;
}

TEST(CellName, drops_what_spreadsheets_add_to_whole_numbers) {
    EXPECT_EQ(cell_name("490251039700.0"), "490251039700");
    EXPECT_EQ(cell_name("4.902510397E11"), "490251039700");
    EXPECT_EQ(cell_name("007"), "007");
    EXPECT_EQ(cell_name(" BH 1 "), "BH 1");
    EXPECT_EQ(cell_name("1.5"), "1.5");
    EXPECT_EQ(cell_name("-"), "");
}

}  // namespace
}  // namespace stratareeb
