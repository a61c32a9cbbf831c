// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/length_unit.h"

#include <gtest/gtest.h>

#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(LengthUnit, has_its_metres) {
    EXPECT_EQ(metres_per("m"), 1);
    EXPECT_EQ(metres_per("ft"), 0.3048);
    EXPECT_EQ(metres_per("us-ft"), 1200.0 / 3937.0);
}

TEST(LengthUnit, that_is_not_known_is_an_error_that_names_those_that_are) {
    for (const char* unit : {"", "yd", "M", "feet"}) {
        try {
            metres_per(unit);
            ADD_FAILURE() << unit;
        } catch (const InvalidInput& e) {
            EXPECT_NE(std::string(e.what()).find("m, ft or us-ft"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace stratareeb
