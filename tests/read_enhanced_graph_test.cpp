// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_enhanced_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <locale>
#include <random>

#include "boreholes/errors.h"
#include "io/write_enhanced_graph.h"
#include "reeb/curve.h"
#include "reeb/graph_conditions.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

//! A merge with all forms of contours and edges.
const std::string kMerge = R"({
 "nodes": [
  {"id": "left", "position": [-2, 0, 0]},
  {"id": 2, "position": [2, 0, 0.5]},
  {"id": "saddle", "position": [0, 0, 4]},
  {"id": "top", "position": [0, 0, 9]}
 ],
 "contours": [
  {"id": 1, "type": "circle", "z": 1, "center": [-2, 0], "radius": 1},
  {"id": "tilted", "type": "circle", "center": [-2, 0, 2], "radius": 1, "normal": [0.25, 0, 1]},
  {"id": 2, "type": "polygon", "z": 1, "points": [[1, -1], [3, -1], [3, 1], [1, 1]]},
  {"id": 3, "type": "bezier", "z": 2, "points": [[1, -1], [4, -1], [4, 1], [1, 1]]},
  {"id": 4, "type": "nurbs", "z": 5, "degree": 2, "points": [[-3, -2], [3, -2], [3, 2], [-3, 2]], "weights": [1, 2, 1, 2]},
  {"id": 5, "type": "cardinal", "z": 6, "points": [[-2, -2], [2, -2], [2, 2], [-2, 2]], "tension": 0.25},
  {"id": 6, "type": "catmull-rom", "points": [[-1, -1, 7], [1, -1, 7.25], [1, 1, 7.25], [-1, 1, 7]], "a": 0.25, "b": 0.75}
 ],
 "edges": [
  {"from": "left", "to": "saddle", "contours": [1, "tilted"], "homotopy": "linear"},
  {"from": 2, "to": "saddle", "curve": {"type": "line", "points": [[2, 0, 1]]}, "contours": [2, 3],
   "homotopy": {"kind": "parabola", "direction": "downward"}},
  {"from": "saddle", "to": "top", "curve": {"type": "cardinal", "points": [[0.5, 0, 6]], "tension": 0.25}, "contours": [4, 5, 6]}
 ]
})";

EnhancedReebGraph parsed(const std::string& text, bool check = true) {
    return parse_enhanced_graph(text, "g.json", {.check = check}).graph;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    if (at == std::string::npos) return text;
    return text.replace(at, what.size(), with);
}

//! What is said of a text that is refused.
std::string refusal(const std::string& text) {
    try {
        parsed(text);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
}

void expect_refusal(const std::string& text, std::initializer_list<const char*> words) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("g.json:")) << message;
    for (const char* word : words)
        EXPECT_NE(message.find(word), std::string::npos) << message << "\nlacks " << word;
}

//! The same for the merge with one place changed: one fault.
void expect_one(const std::string& what, const std::string& with, std::initializer_list<const char*> words) {
    const std::string text = replaced(kMerge, what, with);
    expect_refusal(text, words);
    EXPECT_EQ(refusal(text).find('\n'), std::string::npos) << refusal(text);
}

TEST(ReadEnhancedGraph, reads_every_form) {
    const EnhancedReebGraph graph = parsed(kMerge);
    ASSERT_EQ(graph.nodes.size(), 4u);
    ASSERT_EQ(graph.contours.size(), 7u);
    ASSERT_EQ(graph.edges.size(), 3u);
    EXPECT_EQ(graph.nodes[0].id, GraphId("left"));
    EXPECT_EQ(graph.nodes[1].id, GraphId(std::int64_t{2}));
    EXPECT_EQ(graph.nodes[1].position, (Point3{2, 0, 0.5}));
    for (const auto& contour : graph.contours) EXPECT_TRUE(contour.curve.closed);
    EXPECT_EQ(graph.contours[0].curve.center, (Point3{-2, 0, 1}));
    EXPECT_EQ(graph.contours[0].curve.normal, (Point3{0, 0, 1}));
    EXPECT_EQ(graph.contours[1].curve.normal, (Point3{0.25, 0, 1}));
    EXPECT_EQ(graph.contours[2].curve.kind, CurveKind::Polyline);
    EXPECT_EQ(graph.contours[2].curve.points[2], (Point3{3, 1, 1}));
    EXPECT_EQ(graph.contours[4].curve.degree, 2);
    EXPECT_EQ(graph.contours[4].curve.weights, (std::vector<double>{1, 2, 1, 2}));
    EXPECT_EQ(graph.contours[5].curve.tension, 0.25);
    EXPECT_EQ(graph.contours[6].curve.b, 0.75);
    EXPECT_EQ(graph.contours[6].curve.points[1], (Point3{1, -1, 7.25}));
    EXPECT_EQ(graph.edges[0].curve, Curve{});
    EXPECT_EQ(graph.edges[0].homotopy.kind, HomotopyKind::Linear);
    EXPECT_EQ(graph.edges[0].contours, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(graph.edges[1].from, 1u);
    EXPECT_EQ(graph.edges[1].homotopy.direction, HomotopyDirection::Downward);
    EXPECT_EQ(graph.edges[2].curve.kind, CurveKind::Cardinal);
    EXPECT_EQ(graph.edges[2].homotopy, HomotopyOptions{});
}

TEST(ReadEnhancedGraph, turns_edges_over_that_are_written_from_above) {
    const EnhancedReebGraph graph = parsed(kMerge);
    EXPECT_EQ(
        parsed(replaced(kMerge, R"("from": "left", "to": "saddle")", R"("from": "saddle", "to": "left")")),
        graph);
    const std::string up = R"({"nodes": [{"id": 1, "position": [0, 0, 0]}, {"id": 2, "position": [1, 0, 8]}],
        "contours": [{"id": 1, "type": "circle", "z": 2, "center": [0, 0], "radius": 1},
                     {"id": 2, "type": "circle", "z": 4, "center": [0, 0], "radius": 1}], "edges": [
        {"from": 1, "to": 2, "curve": {"type": "catmull-rom", "points": [[0.5, 1, 2], [0, 2, 5]], "a": 0.25, "b": 0.375},
         "contours": [1, 2]}]})";
    const std::string down = replaced(replaced(up, R"("from": 1, "to": 2)", R"("from": 2, "to": 1)"),
                                      R"([[0.5, 1, 2], [0, 2, 5]], "a": 0.25, "b": 0.375)",
                                      R"([[0, 2, 5], [0.5, 1, 2]], "a": 0.625, "b": 0.75)");
    EXPECT_EQ(parsed(down), parsed(up));
    // What stands in the file is the same curve the other way round.
    EnhancedReebGraph turned = parsed(up);
    auto& edge = turned.edges[0];
    const ParametricCurve rising(curve_of(turned, edge));
    std::swap(edge.from, edge.to);
    edge.curve.points = {{0, 2, 5}, {0.5, 1, 2}};
    edge.curve.a = 0.625;
    edge.curve.b = 0.75;
    const ParametricCurve falling(curve_of(turned, edge));
    for (int i = 0; i <= 30; ++i) {
        const Point3 p = rising.at(i / 30.0), q = falling.at(1 - i / 30.0);
        EXPECT_NEAR(p.x, q.x, 1e-12);
        EXPECT_NEAR(p.y, q.y, 1e-12);
        EXPECT_NEAR(p.z, q.z, 1e-12);
    }
}

TEST(ReadEnhancedGraph, keeps_a_comment_and_takes_a_byte_order_mark) {
    const std::string text = "\xEF\xBB\xBF" + replaced(kMerge, "{", R"({"comment": "Zwei Füße",)");
    const auto file = parse_enhanced_graph(text, "g.json");
    EXPECT_EQ(file.comment, "Zwei Füße");
    EXPECT_EQ(file.graph, parsed(kMerge));
}

class Comma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
};

TEST(ReadEnhancedGraph, numbers_do_not_depend_on_the_locale) {
    const EnhancedReebGraph graph = parsed(kMerge);
    const std::string written = enhanced_graph_text(graph);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    for (const char* german : {"de_DE.UTF-8", "de_DE.utf8"}) std::setlocale(LC_ALL, german);
    const EnhancedReebGraph read_so = parsed(kMerge);
    const std::string written_so = enhanced_graph_text(graph);
    std::setlocale(LC_ALL, "C");
    std::locale::global(before);
    EXPECT_EQ(read_so, graph);
    EXPECT_EQ(written_so, written);
}

TEST(ReadEnhancedGraph, names_the_place_the_value_and_the_way_out) {
    expect_one(R"("radius": 1})", R"("radios": 1, "radius": 1})",
               {"contours[0]", "unknown key \"radios\"", "did you mean \"radius\"", "center"});
    expect_one(R"("radius": 1})", R"("radius": "1"})", {"contours[0].radius", "\"1\"", "a number"});
    expect_one(R"("radius": 1})", R"("radius": null})", {"contours[0].radius", "null"});
    expect_one(R"(, "radius": 1})", "}", {"contours[0]: \"radius\" is missing"});
    expect_one(R"("center": [-2, 0], "radius)", R"("center": [-2, 0, 1], "radius)",
               {"contours[0].center", "a list of 3", "[x, y]", "\"z\""});
    expect_one("[3, 1], [1, 1]]", "[3, 1], [1]]", {"contours[2].points[3]", "a list of 1", "two numbers"});
    expect_one("[3, 1], [1, 1]]", "[3, 1], [1, true]]", {"contours[2].points[3][1]", "true", "a number"});
    expect_one("[3, 1], [1, 1]]", "[3, 1], 7]", {"contours[2].points[3]", "is 7"});
    expect_one("[-1, -1, 7]", "[-1, -1]", {"contours[6].points[0]", "three numbers"});
    expect_one("\"polygon\"", "\"polgon\"",
               {"contours[2].type", "\"polgon\"", "did you mean \"polygon\"", "nurbs"});
    expect_one("\"degree\": 2", "\"degree\": 2.5", {"contours[4].degree", "2.5", "whole number"});
    expect_one("\"degree\": 2", "\"degree\": 99999999999", {"contours[4].degree", "1 to 100"});
    expect_one("\"weights\": [1, 2, 1, 2]", "\"weights\": [1, 2, 1, \"x\"]",
               {"contours[4].weights[3]", "\"x\""});
    expect_one("\"weights\": [1, 2, 1, 2]", "\"weights\": 1", {"contours[4].weights", "a list of numbers"});
    expect_one("{\"type\": \"line\"", "{\"type\": \"bezier\"", {"edges[1].curve.type", "line, cardinal"});
    expect_one("\"linear\"", "\"liner\"", {"edges[0].homotopy", "did you mean \"linear\"", "natural-cubic"});
    expect_one("\"linear\"", "3", {"edges[0].homotopy", "is 3", "kind"});
    expect_one("\"downward\"", "\"down\"", {"edges[1].homotopy.direction", "did you mean \"downward\""});
    expect_one("\"kind\": \"parabola\", ", "", {"edges[1].homotopy", "\"kind\" is missing"});
    expect_one("\"position\": [-2, 0, 0]", "\"position\": [-2, 0]", {"nodes[0].position", "[x, y, z]"});
    expect_one("\"position\": [-2, 0, 0]", "\"position\": 4", {"nodes[0].position", "is 4"});
    expect_one("\"from\": 2,", "", {"edges[1]", "\"from\" is missing"});
    expect_one("[1, \"tilted\"]", "1", {"edges[0].contours", "is 1", "bottom to top"});
    expect_one("{\"id\": \"left\", \"position\": [-2, 0, 0]},",
               "{\"id\": \"left\", \"position\": [-2, 0, 0]}, 5,", {"nodes[1]", "is 5", "object"});
}

TEST(ReadEnhancedGraph, names_must_be_there_and_be_unique) {
    expect_one("[1, \"tilted\"]", "[1, \"titled\"]",
               {"edges[0].contours[1]", "\"titled\"", "did you mean \"tilted\"?"});
    expect_one("[1, \"tilted\"]", "[\"1\", \"tilted\"]", {"edges[0].contours[0]", "is \"1\"", "there is 1)"});
    expect_one("\"to\": \"top\"", "\"to\": \"2\"", {"edges[2].to", "there is 2)"});
    expect_one("\"to\": \"top\"", "\"to\": [1]", {"edges[2].to", "a list of 1", "the id of a node"});
    expect_refusal(replaced(kMerge, "{\"id\": 2, \"type\"", "{\"id\": 1, \"type\""),
                   {"contours[2].id: is 1 (expected a name of its own; contours[0] has that one)"});
    EXPECT_NE(refusal(replaced(kMerge, "\"id\": \"top\"", "\"id\": \"left\"")).find("nodes[0] has that one"),
              std::string::npos);
    expect_refusal(replaced(kMerge, "\"id\": \"tilted\"", "\"id\": 1.5"),
                   {"contours[1].id: is 1.5 (expected a whole number"});
    expect_refusal(replaced(kMerge, "\"id\": \"tilted\"", "\"id\": 18446744073709551615"),
                   {"contours[1].id"});
    expect_refusal(R"({"nodes": [], "contours": [], "edges": [{"from": 1, "to": 2, "contours": [7]}]})",
                   {"3 faults", "edges[0].from", "edges[0].contours[0]", "there are none"});
}

TEST(ReadEnhancedGraph, tells_many_faults_at_once) {
    std::string text = R"({"nodes": [)";
    for (int i = 0; i < 50; ++i) text += std::string(i > 0 ? "," : "") + "{\"id\": true}";
    const std::string message = refusal(text + R"(], "contours": [], "edges": {}})");
    EXPECT_NE(message.find("101 faults"), std::string::npos) << message;
    EXPECT_NE(message.find("and 81 more"), std::string::npos) << message;
    EXPECT_EQ(std::ranges::count(message, '\n'), 21);
}

TEST(ReadEnhancedGraph, refuses_what_is_no_graph) {
    expect_refusal("", {"empty"});
    expect_refusal(" \n ", {"empty"});
    expect_refusal("[1, 2]", {"a list of 2", "nodes, contours and edges"});
    expect_refusal("{}", {"3 faults", "\"nodes\" is missing", "\"edges\" is missing"});
    expect_refusal(R"({"contours": [{"z": 1, "points": [[0, 0], [1, 0], [0, 1]]}]})", {"stack of contours"});
    expect_refusal("{\"nodes\": [\n  {\"id\": 1,, }", {"g.json:2: column 12: not JSON"});
    expect_refusal("{\"nodes\": [", {"g.json:1:", "not JSON", "end of input"});
    expect_refusal("{} {}", {"column 4"});
    expect_refusal("id,x,y\n1,2,3\n", {"g.json:1:", "not JSON"});
    expect_refusal(std::string("\xFF\xFE{\0}\0", 6), {"UTF-16", "UTF-8"});
    expect_refusal("{\"nodes\": \"\xC3\x28\"}", {"not JSON"});
    expect_refusal("{\"nodes\": [NaN]}", {"not JSON"});
}

TEST(ReadEnhancedGraph, refuses_numbers_and_objects_that_json_leaves_open) {
    expect_refusal(replaced(kMerge, "[3, -1]", "[1e999, -1]"), {"contours[2].points[1][0]", "too large"});
    expect_refusal(replaced(kMerge, "[3, -1]", "[3, -1e999]"), {"contours[2].points[1][1]", "too large"});
    expect_refusal(replaced(kMerge, "\"z\": 2,", "\"z\": 2, \"type\": \"nurbs\","),
                   {"contours[3].type", "twice"});
    expect_refusal(replaced(kMerge, "\"edges\"", "\"nodes\": [], \"edges\""), {"nodes", "twice"});
    const std::string deep(1000000, '[');
    expect_refusal("{\"nodes\": " + deep, {"nodes[0][0]", "nested more than 32 deep"});
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
    expect_refusal(objects, {"a.a", "nested more than 32 deep"});
}

TEST(ReadEnhancedGraph, checks_the_graph_unless_told_not_to) {
    const std::string falling = replaced(kMerge, "\"position\": [0, 0, 9]", "\"position\": [0, 0, 6.5]");
    expect_refusal(falling, {"\"top\"", "6.5"});
    EXPECT_EQ(parsed(falling, false).nodes[3].position.z, 6.5);
    EXPECT_EQ(parsed(R"({"nodes": [], "contours": [], "edges": []})"), EnhancedReebGraph{});
}

TEST(ReadEnhancedGraph, files_that_cannot_be_read_are_named) {
    const TemporaryFolder folder;
    EXPECT_EQ(read_enhanced_graph(folder.file("merge.json", kMerge)), parsed(kMerge));
    EXPECT_THROW(read_enhanced_graph(folder / "none.json"), IoError);
    EXPECT_THROW(read_enhanced_graph(folder.path()), IoError);
    try {
        read_enhanced_graph(folder.file("bad.json", "{}"));
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("bad.json"), std::string::npos);
    }
}

TEST(ReadEnhancedGraph, damaged_files_are_refused_or_read_but_never_crash) {
    std::mt19937_64 random(4);
    const std::string bytes = "{}[]\",:0123456789.-eE \\utfnals\x80\xff";
    for (int round = 0; round < 3000; ++round) {
        std::string text = kMerge;
        for (auto count = 1 + random() % 4; count > 0; --count) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = bytes[random() % bytes.size()];
                    break;
                case 1:
                    text.erase(at, 1 + random() % 20);
                    break;
                case 2:
                    text.insert(at, 1, bytes[random() % bytes.size()]);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 40));
            }
        }
        try {
            const EnhancedReebGraph graph = parsed(text, round % 8 == 0);
            EXPECT_EQ(parsed(enhanced_graph_text(graph), false), graph) << text;
        } catch (const InvalidInput& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("g.json:")) << error.what();
        }
    }
}

}  // namespace
}  // namespace stratareeb
