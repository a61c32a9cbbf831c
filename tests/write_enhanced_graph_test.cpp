// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_enhanced_graph.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "boreholes/errors.h"
#include "io/read_enhanced_graph.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

//! Any finite double, also the smallest, the largest and -0.
class Numbers {
 public:
    explicit Numbers(std::uint64_t seed) : random_(seed) {}

    std::size_t below(std::size_t end) { return random_() % end; }
    double next() {
        if (below(8) == 0) return std::array{0.0, -0.0, 5e-324, -1.7976931348623157e308, 0.1, 5e6}[below(6)];
        if (below(2) == 0) return static_cast<double>(below(2001)) / 10 - 100;
        const double any = std::bit_cast<double>(random_());
        return std::isfinite(any) ? any : 1.0 / 3;
    }
    Point3 point() { return {next(), next(), next()}; }
    std::vector<double> list(std::size_t size) {
        std::vector<double> numbers(size);
        for (double& number : numbers) number = next();
        return numbers;
    }

 private:
    std::mt19937_64 random_;
};

Curve random_curve(Numbers& numbers, CurveKind kind, bool closed) {
    Curve curve{.kind = kind, .closed = closed};
    if (kind == CurveKind::Circle) {
        curve.center = numbers.point();
        curve.radius = numbers.next();
        if (numbers.below(2) == 0) curve.normal = numbers.point();
        return curve;
    }
    const double z = numbers.next();
    const bool is_level = numbers.below(2) == 0;
    for (std::size_t i = numbers.below(6); i > 0; --i) {
        curve.points.push_back(numbers.point());
        if (is_level) curve.points.back().z = z;
    }
    if (kind == CurveKind::Nurbs) {
        curve.degree = static_cast<int>(1 + numbers.below(100));
        curve.knots = numbers.list(numbers.below(4));
        curve.weights = numbers.list(numbers.below(4));
    }
    if (kind == CurveKind::Cardinal) curve.tension = numbers.next();
    if (kind == CurveKind::CatmullRom) {
        curve.a = numbers.next();
        curve.b = numbers.next();
    }
    return curve;
}

GraphId random_id(Numbers& numbers, std::size_t i) {
    const auto number = static_cast<std::int64_t>(i);
    switch (numbers.below(4)) {
        case 0:
            return number - 3;
        case 1:
            return std::numeric_limits<std::int64_t>::max() - number;
        case 2:
            return "Schluff \"é\" \\ \n\t/" + std::to_string(i);
        default:
            return std::to_string(i);
    }
}

//! A graph with every form in it and any numbers; not a sound one.
EnhancedReebGraph random_graph(std::uint64_t seed) {
    Numbers numbers(seed);
    EnhancedReebGraph graph;
    for (std::size_t i = 0; i < 5; ++i) graph.nodes.push_back({random_id(numbers, i), numbers.point()});
    for (std::size_t i = 0; i < 12; ++i)
        graph.contours.push_back(
            {random_id(numbers, i), random_curve(numbers, static_cast<CurveKind>(i % 6), true)});
    constexpr std::array kEdgeKinds = {CurveKind::Polyline, CurveKind::Cardinal, CurveKind::CatmullRom};
    for (std::size_t i = 0; i < 12; ++i) {
        EnhancedEdge edge;
        edge.from = static_cast<std::uint32_t>(numbers.below(5));
        edge.to = static_cast<std::uint32_t>(numbers.below(5));
        if (graph.nodes[edge.from].position.z > graph.nodes[edge.to].position.z)
            std::swap(edge.from, edge.to);
        edge.curve = random_curve(numbers, kEdgeKinds[i % 3], false);
        for (std::size_t n = numbers.below(4); n > 0; --n)
            edge.contours.push_back(static_cast<std::uint32_t>(numbers.below(12)));
        edge.homotopy.kind = static_cast<HomotopyKind>(i % 6);
        if (numbers.below(2) == 0) edge.homotopy.direction = HomotopyDirection::Downward;
        if (numbers.below(2) == 0) edge.homotopy.pace = HomotopyPace::Round;
        if (numbers.below(2) == 0) edge.homotopy.tension = numbers.next();
        if (numbers.below(2) == 0) edge.homotopy.a = numbers.next();
        if (numbers.below(2) == 0) edge.homotopy.b = numbers.next();
        graph.edges.push_back(edge);
    }
    return graph;
}

EnhancedReebGraph parsed(const std::string& text) {
    return parse_enhanced_graph(text, "g.json", {.check = false}).graph;
}

TEST(WriteEnhancedGraph, loses_nothing) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const EnhancedReebGraph graph = random_graph(seed);
        const std::string text = enhanced_graph_text(graph);
        EXPECT_EQ(parsed(text), graph) << text;
        EXPECT_EQ(enhanced_graph_text(parsed(text)), text);  // the sign of 0 too
    }
}

TEST(WriteEnhancedGraph, leaves_a_text_that_it_wrote_as_it_is) {
    const std::string text = R"({
 "comment": "a \"cone\"",
 "nodes": [
  {"id": "bottom", "position": [0, 0, 0]},
  {"id": 2, "position": [0, 0, 1.25]}
 ],
 "contours": [
  {"id": 1, "type": "circle", "z": 0.5, "center": [0, 0], "radius": 1},
  {"id": 2, "type": "polygon", "points": [[-1, -1, 0.75], [1, -1, 1], [0, 1, 0.875]]}
 ],
 "edges": [
  {"from": "bottom", "to": 2, "contours": [1, 2], "homotopy": {"kind": "quadrant", "direction": "downward"}}
 ]
}
)";
    const auto file = parse_enhanced_graph(text, "g.json");
    EXPECT_EQ(enhanced_graph_text(file.graph, file.comment), text);
    EXPECT_EQ(parsed(enhanced_graph_text({})), EnhancedReebGraph{});
}

EnhancedReebGraph small() {
    EnhancedReebGraph graph;
    graph.nodes = {{"a", {0, 0, 0}}, {"b", {0, 0, 2}}};
    graph.contours = {{1, {.kind = CurveKind::Circle, .closed = true, .radius = 1}}};
    graph.edges = {{0, 1, {}, {0}, {}}};
    return graph;
}

void expect_refusal(const EnhancedReebGraph& graph, std::initializer_list<const char*> words) {
    try {
        enhanced_graph_text(graph);
        ADD_FAILURE() << "written";
    } catch (const InvalidInput& error) {
        for (const char* word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(WriteEnhancedGraph, refuses_what_would_not_read_back) {
    auto graph = small();
    EXPECT_NO_THROW(enhanced_graph_text(graph));
    graph.nodes[1].position.x = std::nan("");
    expect_refusal(graph, {"nodes[1]", "nan"});
    graph = small();
    graph.contours[0].curve.radius = std::numeric_limits<double>::infinity();
    expect_refusal(graph, {"contours[0]", "inf"});
    graph = small();
    graph.contours[0].curve.closed = false;
    expect_refusal(graph, {"contours[0]", "closed"});
    graph = small();
    graph.nodes[1].id = "a";
    expect_refusal(graph, {"nodes[1]", "name"});
    graph = small();
    graph.nodes[1].id = "\xff";
    expect_refusal(graph, {"nodes[1]", "UTF-8"});
    graph = small();
    graph.edges[0].to = 2;
    expect_refusal(graph, {"edges[0]", "node"});
    graph = small();
    graph.edges[0].contours = {0, 1};
    expect_refusal(graph, {"edges[0]", "contour"});
    graph = small();
    graph.edges[0].curve.kind = CurveKind::Bezier;
    expect_refusal(graph, {"edges[0]", "line"});
}

TEST(WriteEnhancedGraph, a_failed_write_leaves_the_old_file) {
    const TemporaryFolder folder;
    const auto file = folder / "graph.json";
    write_enhanced_graph(file, small());
    const std::string before = content_of(file);
    EXPECT_EQ(before, enhanced_graph_text(small()));
    auto graph = small();
    graph.edges[0].to = 9;
    EXPECT_THROW(write_enhanced_graph(file, graph), InvalidInput);
    EXPECT_EQ(content_of(file), before);
    EXPECT_EQ(folder.size(), 1u);
    EXPECT_THROW(write_enhanced_graph(folder / "none" / "graph.json", small()), IoError);
}

}  // namespace
}  // namespace stratareeb
