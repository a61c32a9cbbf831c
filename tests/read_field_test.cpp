// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>

#include "boreholes/errors.h"
#include "io/read_ply.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

using Values = std::vector<double>;

template <class Read>
std::string message_of(Read read) {
    try {
        read();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

class ReadField : public ::testing::Test {
 protected:
    std::string refusal(const std::string& text, std::size_t count) const {
        const auto file = folder_.file("field.csv", text);
        EXPECT_THROW(read_field(file, count), InvalidInput);
        return message_of([&] { read_field(file, count); });
    }
    Values values(const std::string& text, std::size_t count) const {
        return read_field(folder_.file("field.txt", text), count);
    }
    TemporaryFolder folder_;
};

TEST_F(ReadField, takes_a_number_a_line_with_or_without_a_header) {
    EXPECT_EQ(values("1\n-2.5e3\n0\n", 3), (Values{1, -2500, 0}));
    EXPECT_EQ(values("porosity\r\n0.1\r\n0.25\r\n\r\n", 2), (Values{0.1, 0.25}));
    EXPECT_EQ(values("\xef\xbb\xbf\"value\"\n\"3,5\"\n 4 \n", 2), (Values{3.5, 4}));
    EXPECT_EQ(values("7", 1), (Values{7}));
    EXPECT_EQ(values("", 0), Values{});
    EXPECT_EQ(values("4.9406564584124654e-324\n1.7976931348623157e308", 2),
              (Values{4.9406564584124654e-324, 1.7976931348623157e308}));
}

TEST_F(ReadField, names_every_line_that_is_no_number) {
    const auto message = refusal("1\nnan\n\n3 4\n5\nsix\n>7\n-\n", 8);
    for (const char* part :
         {"field.csv:2: nan is not finite", "field.csv:3: is empty", "field.csv:4: 3 4 is not one number",
          "field.csv:6: six is no number", "field.csv:7: >7 is no number", "field.csv:8: - is no number"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " in\n" << message;
    EXPECT_NE(refusal("inf\n", 1).find("field.csv:1: inf is not finite"), std::string::npos);
}

TEST_F(ReadField, stops_listing_at_twenty) {
    std::string text = "1\n";
    for (int i = 0; i < 1000; ++i) text += std::string(5000, 'x') + "\n";
    const auto message = refusal(text, 1001);
    EXPECT_EQ(std::ranges::count(message, '\n'), 20);
    EXPECT_NE(message.find("and 980 lines more"), std::string::npos);
    EXPECT_LT(message.size(), 5000u);
}

TEST_F(ReadField, counts_one_value_a_vertex) {
    const auto message = refusal("head\n1\n2\n", 5);
    EXPECT_NE(message.find("2 values for a mesh of 5 vertices"), std::string::npos) << message;
    EXPECT_THROW(read_field(folder_ / "none.txt", 1), IoError);
}

TEST_F(ReadField, takes_a_vertex_property_of_a_ply_file) {
    const auto ply = folder_.file("a.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                                  "float y\nproperty float z\nproperty list uchar int ring\nproperty double "
                                  "quality\nelement face 1\nproperty list uchar int "
                                  "vertex_indices\nend_header\n0 0 0 2 8 9 0.5\n1 0 0 0 -1\n0 1 0 1 4 "
                                  "1e9\n3 0 1 2\n");
    EXPECT_EQ(read_ply_property(ply, "quality"), (Values{0.5, -1, 1e9}));
    EXPECT_EQ(read_ply_property(ply, "y"), (Values{0, 0, 1}));
    const auto message = message_of([&] { read_ply_property(ply, "ring"); });
    EXPECT_NE(message.find("no property ring; there are x, y, z, quality"), std::string::npos) << message;
    EXPECT_THROW(read_ply_property(folder_.file("b.ply", "ply\nformat ascii 1.0\nend_header\n"), "x"),
                 InvalidInput);
    EXPECT_THROW(read_ply_property(folder_.file("c.ply",
                                                "ply\nformat binary_little_endian 1.0\nelement vertex "
                                                "99999999999\nproperty double q\nend_header\n12345678"),
                                   "q"),
                 InvalidInput);
}

}  // namespace
}  // namespace stratareeb
