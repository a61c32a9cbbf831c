// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/memory_guard.h"

#include <gtest/gtest.h>

#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(MemoryGuard, estimates_in_proportion_to_triangles) {
    EXPECT_EQ(estimated_memory(0, 5, true), 0);
    const double one = estimated_memory(1e6, 5, true);
    EXPECT_GT(one, 0);
    EXPECT_DOUBLE_EQ(estimated_memory(3e6, 5, true), 3 * one);
}

TEST(MemoryGuard, estimates_more_for_more_layers_and_for_solids_held_together) {
    EXPECT_GT(estimated_memory(1e6, 6, false), estimated_memory(1e6, 5, false));
    EXPECT_GT(estimated_memory(1e6, 5, true), estimated_memory(1e6, 5, false));
    EXPECT_EQ(estimated_memory(1e6, 1, true), estimated_memory(1e6, 1, false));
}

TEST(MemoryGuard, lets_a_small_run_pass) {
    EXPECT_NO_THROW(check_memory(1000, 3, true));
}

TEST(MemoryGuard, refuses_a_run_that_no_machine_can_hold_and_says_the_way_out) {
    try {
        check_memory(1e13, 10, true);
        FAIL() << "10,000,000 million triangles let through";
    } catch (const InvalidInput& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("about 1e+07 million plan triangles in 10 layers need"), std::string::npos)
            << text;
        EXPECT_NE(text.find("GiB are free"), std::string::npos) << text;
        for (const char* way : {"--spacing", "--formats", "--ignore-memory"})
            EXPECT_NE(text.find(way), std::string::npos) << text;
    }
}

TEST(MemoryGuard, refining_is_estimated_by_faces) {
    EXPECT_DOUBLE_EQ(estimated_refine_memory(3e6, false), 3 * estimated_refine_memory(1e6, false));
    EXPECT_GT(estimated_refine_memory(1e6, true), estimated_refine_memory(1e6, false));
    EXPECT_LT(estimated_refine_memory(1e7, false),
              24.0 * (1 << 30));  // ten million triangles fit into 24 GiB
    EXPECT_TRUE(has_refine_memory(1000, true));
    EXPECT_NO_THROW(check_refine_memory(1000, true));
    EXPECT_FALSE(has_refine_memory(1e13, false));
    EXPECT_THROW(check_refine_memory(1e13, false), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
