// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/checked_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

std::string refusal(std::string_view text) {
    try {
        parse_json(text, "f.json");
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

TEST(CheckedJson, names_line_and_column) {
    EXPECT_TRUE(refusal("{\n  \"a\": 1\n  \"b\": 2}").starts_with("f.json:3: column 5: not JSON: "));
    EXPECT_TRUE(refusal("[1, 2,]").starts_with("f.json:1: column 7: not JSON: "));
    EXPECT_TRUE(refusal("[\"\x01\"]").find('\x01') == std::string::npos);
    EXPECT_LT(refusal("[" + std::string(100000, 'x')).size(), 300u);
}

TEST(CheckedJson, names_the_place_of_what_json_leaves_open) {
    EXPECT_EQ(refusal("[[1], {\"a\": [0, 0, {\"b\": 1e999}]}]"),
              "f.json: [1].a[2].b: the number is too large (expected less than 1.8e308)");
    EXPECT_EQ(refusal("1e999"), "f.json: the file: the number is too large (expected less than 1.8e308)");
    EXPECT_EQ(refusal("{\"a\": [{}, {\"b\": 1, \"c\": [2], \"b\": 3}]}"),
              "f.json: a[1].b: it stands there twice; leave one");
    EXPECT_EQ(refusal("[{\"a\": 1}, {\"a\": 1}]"), "accepted");
    EXPECT_EQ(refusal(std::string(32, '[') + std::string(32, ']')), "accepted");
    EXPECT_NE(refusal(std::string(33, '[') + std::string(33, ']')).find("nested"), std::string::npos);
}

TEST(CheckedJson, finds_the_nearest_word) {
    const std::vector<std::string_view> words = {"radius", "center", "normal", "z"};
    EXPECT_EQ(nearest_word("radios", words), "radius");
    EXPECT_EQ(nearest_word("centre", words), "center");
    EXPECT_EQ(nearest_word("norm", words), "normal");
    EXPECT_EQ(nearest_word("Z", words), "z");
    EXPECT_EQ(nearest_word("x", std::vector<std::string_view>{"b", "a"}), "b");
    EXPECT_EQ(nearest_word("x", {}), "");
}

TEST(CheckedJson, items_tell_what_they_are_not) {
    const auto document =
        parse_json(R"({"n": 1.5, "t": "é é é é é é é é é é é é é é é é é é é é", "l": [1, null]})", "f.json");
    FileFaults faults("f.json");
    const JsonItem item(document, "", faults);
    EXPECT_EQ(item.need("n")->number(), 1.5);
    EXPECT_NO_THROW(faults.throw_if_any());
    EXPECT_FALSE(item.need("n")->whole_number());
    EXPECT_FALSE(item.need("t")->number());
    EXPECT_FALSE(item.need("l")->numbers());
    EXPECT_FALSE(item.need("l")->text());
    EXPECT_TRUE(item.need("t")->list("a list").empty());
    EXPECT_FALSE(item.need("m"));
    EXPECT_EQ(faults.count(), 6u);
    try {
        faults.throw_if_any();
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_EQ(std::string(error.what()),
                  "f.json: 6 faults\n  n: is 1.5 (expected a whole number)\n"
                  "  t: is \"é é é é é é é é é é é é é é é é… (expected a number)\n"
                  "  l[1]: is null (expected a number)\n  l: is a list of 2 (expected a text)\n"
                  "  t: is \"é é é é é é é é é é é é é é é é… (expected a list)\n  \"m\" is missing");
    }
}

}  // namespace
}  // namespace stratareeb
