// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/progress.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stratareeb {
namespace {

TEST(Progress, time_left_is_in_proportion_to_the_time_gone) {
    EXPECT_EQ(progress_line("build", "plan mesh", 0.25, 4), "build: plan mesh, 25 %, 12 s left");
    EXPECT_EQ(progress_line("build", "plan mesh", 0.5, 75), "build: plan mesh, 50 %, 1 min 15 s left");
    EXPECT_EQ(progress_line("build", "STEP", 0.1, 600), "build: STEP, 10 %, 1 h 30 min left");
}

TEST(Progress, no_time_is_told_before_it_is_known) {
    EXPECT_EQ(progress_line("build", "reading", 0, 5), "build: reading, 0 %");
    EXPECT_EQ(progress_line("build", "reading", 0.02, 5), "build: reading, 2 %");
    EXPECT_EQ(progress_line("build", "reading", 0.5, 0.2), "build: reading, 50 %");
    EXPECT_EQ(progress_line("build", "done", 1, 5), "build: done, 100 %");
    EXPECT_EQ(progress_line("build", "x", std::nan(""), 5), "build: x, 0 %");
    EXPECT_EQ(progress_line("build", "x", 7, 5), "build: x, 100 %");
}

TEST(Progress, draws_over_its_line_and_wipes_it) {
    testing::internal::CaptureStderr();
    {
        Progress progress("build", true);
        progress.step("one", 0);
        progress.step("one", 0.001);  // within a tenth of a second: not drawn
        progress.step("two", 0.5);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "\r\033[Kbuild: one, 0 %\r\033[Kbuild: two, 50 %\r\033[K");
}

TEST(Progress, is_silent_where_nobody_watches) {
    testing::internal::CaptureStderr();  // standard error is a file now
    {
        Progress progress("build");
        progress.step("one", 0);
        progress.step("two", 1);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace stratareeb
