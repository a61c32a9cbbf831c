// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_conditions.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

Curve circle(double x, double y, double z, double radius) {
    Curve curve{.kind = CurveKind::Circle, .closed = true};
    curve.center = {x, y, z};
    curve.radius = radius;
    return curve;
}

Curve polygon(std::vector<Point3> points) {
    return {.kind = CurveKind::Polyline, .closed = true, .points = std::move(points)};
}

//! A merge: two stumps from below, one stem above.
EnhancedReebGraph merge() {
    EnhancedReebGraph graph;
    graph.nodes = {{"left", {-2, 0, 0}}, {"right", {2, 0, 0.5}}, {"saddle", {0, 0, 2}}, {"top", {0, 0, 4}}};
    graph.contours = {{1, circle(-2, 0, 1, 1)}, {2, circle(2, 0, 1, 1)}, {3, circle(0, 0, 3, 2)}};
    graph.edges = {{0, 2, {}, {0}, {}}, {1, 2, {}, {1}, {}}, {2, 3, {}, {2}, {}}};
    return graph;
}

//! The one fault of a graph.
std::string fault_of(const EnhancedReebGraph& graph) {
    const auto faults = faults_of(graph);
    std::string all;
    for (const auto& fault : faults) all += fault + "\n";
    EXPECT_EQ(faults.size(), 1u) << all;
    return all;
}

void expect_fault(const EnhancedReebGraph& graph, std::initializer_list<const char*> words) {
    const std::string fault = fault_of(graph);
    for (const char* word : words)
        EXPECT_NE(fault.find(word), std::string::npos) << fault << "lacks " << word;
}

TEST(GraphConditions, hold_for_a_sound_graph) {
    EXPECT_TRUE(faults_of(merge()).empty());
    EXPECT_NO_THROW(check_graph(merge()));
    EXPECT_TRUE(faults_of({}).empty());
}

TEST(GraphConditions, names_are_unique_and_things_belong_together) {
    auto graph = merge();
    graph.nodes[1].id = "left";
    expect_fault(graph, {"two nodes", "\"left\""});
    graph = merge();
    graph.contours.push_back({9, circle(9, 9, 9, 1)});
    expect_fault(graph, {"contour 9", "0 edges"});
    graph = merge();
    graph.nodes.push_back({"alone", {5, 5, 5}});
    expect_fault(graph, {"node \"alone\"", "no edge"});
    graph = merge();
    graph.edges[2].contours.clear();
    graph.contours.pop_back();
    expect_fault(graph, {"from node \"saddle\" to node \"top\"", "no contour"});
}

TEST(GraphConditions, edges_rise_as_curves_and_not_only_in_their_points) {
    auto graph = merge();
    graph.edges[0].curve.points = {{-2, 0, 3}};
    expect_fault(graph, {"node \"left\"", "does not rise", "z = 3"});
    // Control points that rise, and a spline through them that swings back.
    graph = merge();
    graph.nodes[3].position.z = 40;
    graph.edges[2].curve = {.kind = CurveKind::Cardinal, .points = {{0, 0, 3.5}, {0, 0, 3.51}, {0, 0, 3.52}}};
    graph.edges[2].curve.tension = 0.9;
    expect_fault(graph, {"does not rise"});
    graph = merge();
    std::swap(graph.edges[2].from, graph.edges[2].to);
    EXPECT_FALSE(faults_of(graph).empty());
}

TEST(GraphConditions, contours_are_simple_planar_and_run_alike) {
    auto graph = merge();
    graph.contours[1].curve = polygon({{2, -1, 1}, {3, 1, 1}, {3, -1, 1}, {2, 1.5, 1}});
    expect_fault(graph, {"contour 2", "crosses"});
    graph.contours[1].curve = polygon({{2, -1, 1}, {3, -1, 1.1}, {3, 1, 1}, {2, 1, 1.1}});
    expect_fault(graph, {"contour 2", "one plane"});
    graph.contours[1].curve = polygon({{2, -1, 1}, {2, 1, 1}, {3, 1, 1}, {3, -1, 1}});
    expect_fault(graph, {"contour 2", "clockwise"});
    graph.contours[1].curve = polygon({{2, -1, 1}, {3, 1, 1}});
    expect_fault(graph, {"contour 2", "2 points"});
    graph.contours[1].curve = circle(2, 0, 1, -1);
    expect_fault(graph, {"contour 2"});
}

TEST(GraphConditions, contours_stand_in_order_between_their_nodes) {
    auto graph = merge();
    graph.contours[2].curve = circle(0, 0, 1.5, 0.2);
    expect_fault(graph, {"contour 3", "1.5", "not above"});
    graph.contours[2].curve = circle(0, 0, 4.5, 0.2);
    expect_fault(graph, {"contour 3", "not below"});
    graph.contours[2].curve = circle(0, 0, 4, 1);
    EXPECT_TRUE(faults_of(graph).empty()) << "a flat end";
    graph.contours[2].curve = circle(0, 0, 2, 0.2);
    expect_fault(graph, {"contour 3", "not above"});
    // Through the saddle itself, as two loops of a figure eight.
    graph = merge();
    graph.contours[0].curve = polygon({{0, 0, 2}, {-1, 1, 2}, {-2, 0, 2}, {-1, -1, 2}});
    graph.contours[1].curve = polygon({{0, 0, 2}, {1, -1, 2}, {2, 0, 2}, {1, 1, 2}});
    EXPECT_TRUE(faults_of(graph).empty());
    graph.contours[1].curve = polygon({{0, 0, 2}, {-1.5, -1, 2}, {2, -1, 2}, {2, 1, 2}});
    expect_fault(graph, {"contour 1 and contour 2", "meet"});
}

TEST(GraphConditions, contours_do_not_meet) {
    auto graph = merge();
    graph.contours[1].curve = circle(-0.5, 0, 1, 1);
    expect_fault(graph, {"contour 1 and contour 2", "height 1"});
    graph.contours[1].curve = circle(-2, 0, 1, 0.5);
    EXPECT_TRUE(faults_of(graph).empty()) << "one within the other";
    // Tilted contours: one leans over the other's rim, or passes by.
    graph.contours[1].curve = circle(-1.5, 0, 1, 0.5);
    graph.contours[1].curve.normal = {0, 0.3, 1};
    expect_fault(graph, {"contour", "meet near"});
    graph.contours[1].curve = circle(2, 0, 1, 0.5);
    graph.contours[1].curve.normal = {0.3, 0, 1};
    EXPECT_TRUE(faults_of(graph).empty());
}

TEST(GraphConditions, are_told_all_at_once) {
    auto graph = merge();
    graph.contours[0].curve = circle(-2, 0, 1, 0);
    graph.edges[2].contours.clear();
    try {
        check_graph(graph);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("3 faults"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace stratareeb
