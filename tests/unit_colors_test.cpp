// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/unit_colors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace stratareeb {
namespace {

//! Relative luminance of an sRGB colour, 0 … 1.
double luminance(const std::string& color) {
    double sum = 0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
        sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

TEST(UnitColors, are_six_hex_digits_and_differ) {
    std::set<std::string> met;
    for (std::size_t i = 0; i < 120; ++i) {
        const std::string color = unit_color(i);
        ASSERT_EQ(color.size(), 7u);
        EXPECT_EQ(color[0], '#');
        EXPECT_EQ(color.find_first_not_of("0123456789abcdef", 1), std::string::npos);
        EXPECT_TRUE(met.insert(color).second) << i << ' ' << color;
    }
}

TEST(UnitColors, neighbours_among_the_first_eight_differ_in_lightness) {
    for (std::size_t i = 0; i + 1 < 8; ++i)
        EXPECT_GT(std::abs(luminance(unit_color(i)) - luminance(unit_color(i + 1))), 0.1) << i;
}

TEST(UnitColors, stated_colours_stay) {
    std::vector<Unit> units{{"a", "a", ""}, {"b", "b", "#123456"}};
    color_units(units);
    EXPECT_EQ(units[0].color, unit_color(0));
    EXPECT_EQ(units[1].color, "#123456");
}

}  // namespace
}  // namespace stratareeb
