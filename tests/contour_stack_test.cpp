// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_stack.h"

#include <gtest/gtest.h>

#include <limits>

#include "boreholes/errors.h"
#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::rectangle;

std::string message_of(const ContourStack& stack) {
    try {
        sorted_stack(stack);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(ContourStack, contours_are_sorted_turned_and_freed_of_repeats) {
    StackContour clockwise{
        .z = 2, .points = {{4, 4}, {4, 4}, {4, 0}, {0, 0}, {0, 4}, {0, 4}, {4, 4}}, .name = {}};
    const SortedStack sorted =
        sorted_stack({{rectangle(2, 5, 0, 6, 1), clockwise, rectangle(-1, 9, 9, 10, 10)}});
    EXPECT_EQ(sorted.source, (std::vector<std::uint32_t>{2, 1, 0}));
    EXPECT_EQ(sorted.first, (std::vector<std::uint32_t>{0, 1, 3}));
    EXPECT_EQ(sorted.levels(), 2u);
    EXPECT_EQ(sorted.contours[1].points, (std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
    EXPECT_EQ(sorted.contours[1].name, "contour 2");
}

TEST(ContourStack, zero_and_minus_zero_are_one_level) {
    EXPECT_EQ(sorted_stack({{rectangle(0.0, 0, 0, 1, 1), rectangle(-0.0, 2, 0, 3, 1)}}).levels(), 1u);
}

TEST(ContourStack, every_contour_without_inside_is_told) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string text = message_of({{{.z = 0, .points = {}, .name = "empty"},
                                          {.z = 0, .points = {{1, 1}, {1, 1}, {1, 1}}, .name = "dot"},
                                          {.z = 0, .points = {{0, 0}, {1, 1}, {2, 2}}, .name = "line"},
                                          {.z = nan, .points = {{0, 0}, {1, 1}, {0, 2}}, .name = "lost"},
                                          {.z = 0, .points = {{0, 0}, {1, nan}, {0, 2}}, .name = "holed"}}});
    for (const char* part :
         {"empty: a closed ring has three points or more, this one 0", "dot: a closed ring",
          "line: it encloses no area", "lost: its height", "holed: its point 2"})
        EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
}

TEST(ContourStack, contours_that_meet_are_told_with_the_place) {
    const std::string text =
        message_of({{rectangle(0, 0, 0, 2, 2),
                     rectangle(0, 2, 0, 3, 2),
                     rectangle(1, 0, 0, 1, 1),
                     rectangle(1, 0, 0, 1, 1),
                     {.z = 2, .points = {{0, 0}, {2, 0}, {1, 0}, {1, 1}}, .name = "spike"}}});
    for (const char* part : {"contour 1 and contour 2 cross or touch near", "contour 3 and contour 4",
                             "spike crosses or touches itself", "at height 2"})
        EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
    EXPECT_EQ(message_of({{rectangle(0, 0, 0, 2, 2), rectangle(1, 2, 0, 3, 2)}}), "") << "not of one height";
}

TEST(ContourStack, long_lists_of_faults_are_counted) {
    ContourStack stack;
    for (int i = 0; i < 100; ++i) stack.contours.push_back({.z = 0, .points = {}, .name = {}});
    EXPECT_NE(message_of(stack).find("and 80 more"), std::string::npos);
}

}  // namespace
}  // namespace stratareeb
