// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_creases.h"

#include <gtest/gtest.h>

#include <fstream>

#include "boreholes/errors.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

class ReadCreases : public testing::Test {
 protected:
    CreaseList read(const std::string& text, const std::vector<std::string>& features = {}) {
        std::ofstream(folder_ / "creases.txt") << text;
        return read_creases(folder_ / "creases.txt", features);
    }
    std::string refusal(const std::string& text, const std::vector<std::string>& features = {}) {
        try {
            read(text, features);
        } catch (const InvalidInput& error) {
            const std::string message = error.what();
            return message.substr(message.find("creases.txt"));
        }
        return "";
    }
    TemporaryFolder folder_;
};

TEST_F(ReadCreases, edges_lines_corners_and_comments) {
    const auto list = read("# of a lens\n\n3 4\n4, 5, 1.5 # soft\nline 7 8 9 7\ncorner 3\r\ncorner 4 0.5\n");
    ASSERT_EQ(list.creases.size(), 5u);
    const std::uint32_t ends[][2] = {{3, 4}, {4, 5}, {7, 8}, {8, 9}, {9, 7}};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(list.creases[i].from, ends[i][0]);
        EXPECT_EQ(list.creases[i].to, ends[i][1]);
        EXPECT_EQ(list.creases[i].sharpness, i == 1 ? 1.5 : kInfiniteSharpness);
    }
    ASSERT_EQ(list.corners.size(), 2u);
    EXPECT_EQ(list.corners[0].vertex, 3u);
    EXPECT_EQ(list.corners[0].sharpness, kInfiniteSharpness);
    EXPECT_EQ(list.corners[1].sharpness, 0.5);
}

TEST_F(ReadCreases, tables_may_have_a_head) {
    EXPECT_EQ(read("from,to,sharpness\n1,2,3\n").creases.size(), 1u);
    EXPECT_EQ(read("from;to\n1;2\n2;3").creases.size(), 2u);
    EXPECT_TRUE(read("").creases.empty());
}

TEST_F(ReadCreases, features_are_taken_by_name) {
    const std::string text =
        "0 1\nfeature fault\n1 2\ncorner 2\nfeature pinch-out\n2 3\n3 4\nfeature fault\n4 5\n";
    EXPECT_EQ(read(text).creases.size(), 5u);
    EXPECT_EQ(read(text, {"fault"}).creases.size(), 2u);
    EXPECT_EQ(read(text, {"fault"}).corners.size(), 1u);
    EXPECT_EQ(read(text, {"pinch-out"}).creases.size(), 2u);
    EXPECT_EQ(read(text, {"pinch-out", "fault"}).creases.size(), 4u);
    EXPECT_EQ(refusal(text, {"rim"}), "creases.txt: there is no feature rim; there are fault, pinch-out");
    EXPECT_EQ(refusal("1 2\n", {"rim"}), "creases.txt: there is no feature rim; there are none");
}

TEST_F(ReadCreases, damage_is_named_with_its_line) {
    EXPECT_EQ(refusal("0 1\n2\n"), "creases.txt:2: expected: FROM TO [SHARPNESS]");
    EXPECT_EQ(refusal("0 1 2 3\n"), "creases.txt:1: expected: FROM TO [SHARPNESS]");
    EXPECT_EQ(refusal("0 -1\n"), "creases.txt:1: -1 is no number of a vertex; they begin with 0");
    EXPECT_EQ(refusal("0 99999999999\n"),
              "creases.txt:1: 99999999999 is no number of a vertex; they begin with 0");
    EXPECT_EQ(refusal("0 1 -2\n"), "creases.txt:1: a sharpness of -2; it is 0 or more");
    EXPECT_EQ(refusal("line 1\n"), "creases.txt:1: a line of edges needs two vertices or more");
    EXPECT_EQ(refusal("corner\n"), "creases.txt:1: expected: corner VERTEX [SHARPNESS]");
    EXPECT_EQ(refusal("feature\n"), "creases.txt:1: expected: feature NAME, in one word");
    EXPECT_NE(refusal("0 x\n"), "");
    EXPECT_NE(refusal("0 1.5\n"), "");
    EXPECT_NE(refusal("0 1 nan\n"), "");
    EXPECT_THROW(read_creases(folder_ / "none.txt"), IoError);
}

}  // namespace
}  // namespace stratareeb
