// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/pinch_out.h"

#include <gtest/gtest.h>

#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(PinchOut, has_a_fraction_for_each_name) {
    EXPECT_EQ(pinch_out_rule("at-hole").fraction, 0);
    EXPECT_EQ(pinch_out_rule("quarter").fraction, 0.25);
    EXPECT_EQ(pinch_out_rule("third").fraction, 1.0 / 3);
    EXPECT_EQ(pinch_out_rule("half").fraction, 0.5);
}

TEST(PinchOut, is_half_way_unless_told) {
    EXPECT_EQ(PinchOutRule{}.fraction, pinch_out_rule("half").fraction);
}

TEST(PinchOut, refuses_other_names_and_says_which_there_are) {
    for (const char* name : {"", "Half", "0.5", "two-thirds"}) {
        try {
            pinch_out_rule(name);
            FAIL() << name;
        } catch (const InvalidInput& error) {
            EXPECT_EQ(error.what(), "unknown pinch-out rule '" + std::string(name) +
                                        "' (expected at-hole, quarter, third or half)");
        }
    }
}

}  // namespace
}  // namespace stratareeb
