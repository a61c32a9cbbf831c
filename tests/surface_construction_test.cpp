// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_construction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "reeb/arc_length.h"
#include "reeb/collapse_plateaus.h"
#include "tests/arc_heights.h"
#include "tests/random_graphs.h"

namespace stratareeb {
namespace {

using testing::arcs_of;

Curve circle(double x, double y, double z, double radius) {
    Curve curve;
    curve.kind = CurveKind::Circle;
    curve.closed = true;
    curve.center = {x, y, z};
    curve.radius = radius;
    return curve;
}

Curve polygon(std::vector<Point3> points) {
    Curve curve;
    curve.closed = true;
    curve.points = std::move(points);
    return curve;
}

//! Nodes by place; edges by nodes, each with its contours.
struct Line {
    std::uint32_t from, to;
    std::vector<Curve> contours;
};

EnhancedReebGraph graph_of(const std::vector<Point3>& nodes, const std::vector<Line>& lines,
                           HomotopyKind homotopy = HomotopyKind::NaturalCubic) {
    EnhancedReebGraph graph;
    for (const Point3& p : nodes) {
        graph.nodes.emplace_back().id = static_cast<std::int64_t>(graph.nodes.size());
        graph.nodes.back().position = p;
    }
    for (const Line& line : lines) {
        EnhancedEdge edge{.from = line.from, .to = line.to, .curve = {}, .contours = {}, .homotopy = {}};
        edge.homotopy.kind = homotopy;
        for (const Curve& curve : line.contours) {
            edge.contours.push_back(static_cast<std::uint32_t>(graph.contours.size()));
            graph.contours.emplace_back().id = static_cast<std::int64_t>(graph.contours.size());
            graph.contours.back().curve = curve;
        }
        graph.edges.push_back(std::move(edge));
    }
    return graph;
}

EnhancedReebGraph merge() {
    return graph_of(
        {{-2, 0, 0}, {2, 0, 0.5}, {0, 0, 2}, {0, 0, 4}},
        {{0, 2, {circle(-2, 0, 1, 1)}}, {1, 2, {circle(2, 0, 1, 1)}}, {2, 3, {circle(0, 0, 3, 2)}}});
}

EnhancedReebGraph torus() {
    return graph_of({{0, 0, -4}, {0, 0, -2}, {0, 0, 2}, {0, 0, 4}},
                    {{0, 1, {circle(0, 0, -3, 2)}},
                     {1, 2, {circle(-3, 0, -1, 1), circle(-3, 0, 1, 1)}},
                     {1, 2, {circle(3, 0, -1, 1), circle(3, 0, 1, 1)}},
                     {2, 3, {circle(0, 0, 3, 2)}}});
}

//! A graph turned upside down.
EnhancedReebGraph mirrored(EnhancedReebGraph graph) {
    for (auto& node : graph.nodes) node.position.z *= -1;
    for (auto& contour : graph.contours) {
        contour.curve.center.z *= -1;
        for (Point3& p : contour.curve.points) p.z *= -1;
    }
    for (auto& edge : graph.edges) {
        std::swap(edge.from, edge.to);
        std::ranges::reverse(edge.contours);
    }
    return graph;
}

//! Closed, manifold, outward, not crossing itself, and with the graph it was made from.
void expect_surface_of(const EnhancedReebGraph& graph, const ConstructedSurface& surface,
                       const std::string& name, bool may_cross = false) {
    const MeshReport report = analyze(surface.soup, {.self_intersections = !may_cross});
    ASSERT_TRUE(report.closed && report.manifold && report.oriented) << name;
    EXPECT_TRUE(may_cross || report.self_intersections == 0) << name;
    EXPECT_GT(report.volume, 0) << name;
    EXPECT_EQ(report.genus, loops_of(graph)) << name;
    EXPECT_EQ(surface.triangle_edge.size(), surface.soup.triangles.size());
    const TriMesh mesh = half_edge_mesh(surface.soup);
    const ReebGraph reeb = collapse_plateaus(reeb_graph(mesh, height_field(mesh)));
    EXPECT_EQ(arcs_of(reeb), arcs_of(graph)) << name;
    EXPECT_EQ(reeb.nodes.size(), graph.nodes.size()) << name;
    // Every given contour is on the surface, point by point.
    std::set<std::tuple<double, double, double>> places;
    for (const Point3& p : surface.soup.points) places.emplace(p.x, p.y, p.z);
    for (const auto& contour : graph.contours)
        for (const Point3& p : sample_contour(contour.curve, SurfaceOptions{}.samples).points)
            ASSERT_TRUE(places.contains({p.x, p.y, p.z})) << name;
}

void expect_surface(const EnhancedReebGraph& graph, const std::string& name) {
    for (const std::size_t steps : {1u, 2u, 5u})
        for (const BandTriangulation triangulation :
             {BandTriangulation::Greedy, BandTriangulation::Automatic})
            expect_surface_of(graph,
                              construct_surface(graph, {.steps = steps, .triangulation = triangulation}),
                              name + ", " + std::to_string(steps) + " steps");
}

TEST(SurfaceConstruction, merges_divides_and_makes_handles) {
    expect_surface(merge(), "merge");
    expect_surface(mirrored(merge()), "divide");
    expect_surface(torus(), "torus");
    // Three at once.
    std::vector<Point3> nodes{{0, 0, 2}, {0, 0, 4}};
    std::vector<Line> lines{{0, 1, {circle(0, 0, 3, 3)}}};
    for (int k = 0; k < 3; ++k) {
        const double angle = 2 * std::numbers::pi * k / 3, x = 2 * std::cos(angle), y = 2 * std::sin(angle);
        nodes.push_back({x, y, 0.1 * k});
        lines.push_back({static_cast<std::uint32_t>(nodes.size() - 1), 0, {circle(x, y, 1, 1)}});
    }
    expect_surface(graph_of(nodes, lines), "three stumps");
    expect_surface(mirrored(graph_of(nodes, lines)), "three branches");
}

// A cup lying on its side in the end: its rim and its hollow join where the wall is lowest.
TEST(SurfaceConstruction, joins_a_contour_and_its_hole) {
    std::vector<Point3> crescent;
    constexpr int kCorners = 40;
    for (int i = 0; i <= kCorners; ++i) {
        const double a = 0.3 + (2 * std::numbers::pi - 0.6) * i / kCorners;
        crescent.push_back({3 * std::cos(a), 3 * std::sin(a), 3.5});
    }
    for (int i = kCorners; i >= 0; --i) {
        const double a = 0.4 + (2 * std::numbers::pi - 0.8) * i / kCorners;
        crescent.push_back({1.5 * std::cos(a), 1.5 * std::sin(a), 3.5});
    }
    const auto graph = graph_of(
        {{0, 0, 0}, {0, 0, 1.5}, {2.5, 0, 3}, {-2.2, 0, 4.5}},
        {{0, 2, {circle(0, 0, 2, 3)}}, {1, 2, {circle(0.2, 0, 2, 1.5)}}, {2, 3, {polygon(crescent)}}});
    expect_surface(graph, "cup");
    expect_surface(mirrored(graph), "bell");
}

TEST(SurfaceConstruction, leaves_cavities) {
    auto graph = graph_of({{0, 0, -2}, {0, 0, 2}, {0, 0, -1}, {0, 0, 1}},
                          {{0, 1, {circle(0, 0, 0, 2)}}, {2, 3, {circle(0, 0, 0.1, 1)}}});
    const auto surface = construct_surface(graph, {.steps = 24, .samples = 200});
    const MeshReport report = analyze(surface.soup);
    EXPECT_TRUE(report.closed && report.oriented);
    EXPECT_EQ(report.self_intersections, 0u);
    EXPECT_NEAR(report.volume, 4 * std::numbers::pi / 3 * (8 - 1), 0.15);
}

double volume_of_sphere(std::size_t contours, HomotopyKind kind, std::size_t steps) {
    std::vector<Curve> circles;
    for (std::size_t k = 1; k <= contours; ++k) {
        const double z = -1 + 2 * static_cast<double>(k) / static_cast<double>(contours + 1);
        circles.push_back(circle(0, 0, z, std::sqrt(1 - z * z)));
    }
    const auto graph = graph_of({{0, 0, -1}, {0, 0, 1}}, {{0, 1, circles}}, kind);
    return analyze(construct_surface(graph, {.steps = steps, .samples = 600}).soup,
                   {.self_intersections = false})
        .volume;
}

// One contour, its equator, gives back a sphere exactly; more contours a better and better one with smooth homotopies.
TEST(SurfaceConstruction, of_a_sphere_converges_to_it) {
    const double exact = 4 * std::numbers::pi / 3;
    const double coarse = std::abs(volume_of_sphere(1, HomotopyKind::NaturalCubic, 20) - exact),
                 fine = std::abs(volume_of_sphere(1, HomotopyKind::NaturalCubic, 40) - exact);
    EXPECT_LT(fine, 0.005);
    EXPECT_LT(fine, coarse / 3) << "second order in the number of steps";
    double before = 1;
    for (const std::size_t contours : {4u, 8u, 16u, 32u}) {
        const double error = std::abs(volume_of_sphere(contours, HomotopyKind::Cardinal, 12) - exact);
        EXPECT_LT(error, before / 2);
        before = error;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(SurfaceConstruction, closes_flat_where_a_contour_lies_at_the_end) {
    const auto square = [](double z) {
        return polygon({{0, 0, z}, {3, 0, z}, {3, 1, z}, {1, 1, z}, {1, 3, z}, {0, 3, z}});
    };
    const auto graph = graph_of({{0.5, 0.5, 0}, {0.5, 0.5, 2}}, {{0, 1, {square(0), square(1), square(2)}}});
    const auto surface = construct_surface(graph);
    const MeshReport report = analyze(surface.soup);
    EXPECT_TRUE(report.watertight);
    EXPECT_NEAR(report.volume, 2 * 5, 1e-12);
}

TEST(SurfaceConstruction, leans_along_a_curved_edge) {
    auto graph = graph_of({{0, 0, 0}, {0, 0, 10}}, {{0, 1, {circle(0, 0, 2, 1), circle(0, 0, 8, 1)}}});
    graph.edges[0].curve.kind = CurveKind::Cardinal;
    graph.edges[0].curve.points = {{0, 0, 2}, {2, 0, 5}, {0, 0, 8}};
    const auto surface = construct_surface(graph, {.steps = 8});
    expect_surface_of(graph, surface, "lean");
    double furthest = 0;
    for (const Point3& p : surface.soup.points) furthest = std::max(furthest, p.x);
    EXPECT_NEAR(furthest, 3, 0.01) << "half way, the contours are where the edge is";
    // A straight edge says nothing about where contours between are.
    graph.edges[0].curve = {};
    for (const Point3& p : construct_surface(graph, {.steps = 8}).soup.points) EXPECT_LE(p.x, 1 + 1e-12);
}

TEST(SurfaceConstruction, passes_through_contours_at_a_saddle) {
    auto graph = merge();
    graph.edges[0].contours.push_back(3);
    graph.edges[1].contours.push_back(4);
    graph.contours.resize(5);
    graph.contours[3] = {11, polygon({{0, 0, 2}, {-1, 1, 2}, {-3, 0.5, 2}, {-3, -0.5, 2}, {-1, -1, 2}})};
    graph.contours[4] = {12, polygon({{0, 0, 2}, {1, -1, 2}, {3, -0.5, 2}, {3, 0.5, 2}, {1, 1, 2}})};
    expect_surface(graph, "a figure eight");
    expect_surface(mirrored(graph), "the same upside down");
}

TEST(SurfaceConstruction, gives_back_the_graph_of_a_thousand_random_ones) {
    std::size_t loops = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const EnhancedReebGraph graph = testing::random_graph(seed);
        loops += loops_of(graph);
        ASSERT_NO_FATAL_FAILURE(expect_surface_of(graph, construct_surface(graph, {.steps = 2 + seed % 3}),
                                                  "seed " + std::to_string(seed), seed % 10 != 0));
    }
    EXPECT_GT(loops, 100u);
}

// A plate with a hole, lying flat: both its ends are ridges all around.
TEST(SurfaceConstruction, makes_ridges_around_a_ring) {
    const auto graph =
        graph_of({{2, 0, 0}, {2, 0, 2}}, {{0, 1, {circle(0, 0, 1, 3)}}, {0, 1, {circle(0.1, 0, 1, 1)}}});
    const auto surface = construct_surface(graph);
    expect_surface_of(graph, surface, "ring");
    EXPECT_TRUE(surface.crossings.empty());
}

// Five stumps in a row join at one height: no point lies between them all.
TEST(SurfaceConstruction, joins_many_contours_across_the_gaps_between_them) {
    std::vector<Point3> nodes{{0, 0.2, 2}, {0, 0, 4}};
    std::vector<Point3> oval;
    for (int k = 0; k < 64; ++k) {
        const double angle = 2 * std::numbers::pi * k / 64;
        oval.push_back({6.5 * std::cos(angle), 2 * std::sin(angle), 3});
    }
    std::vector<Line> lines{{0, 1, {polygon(oval)}}};
    for (int k = -2; k <= 2; ++k) {
        nodes.push_back({2.4 * k, 0, 0.01 * k});
        lines.push_back(
            {static_cast<std::uint32_t>(nodes.size() - 1), 0, {circle(2.4 * k, 0, 1, 0.9 + 0.02 * k)}});
    }
    expect_surface(graph_of(nodes, lines), "five stumps");
    expect_surface(mirrored(graph_of(nodes, lines)), "five branches");
}

// A horseshoe shrinks to a point in one of its arms.
TEST(SurfaceConstruction, caps_contours_that_see_no_center) {
    const auto shoe =
        polygon({{0, 0, 1}, {9, 0, 1}, {9, 9, 1}, {7, 9, 1}, {7, 2, 1}, {2, 2, 1}, {2, 9, 1}, {0, 9, 1}});
    expect_surface(graph_of({{1, 8, 0}, {8, 8, 2}}, {{0, 1, {shoe}}}), "horseshoe");
}

TEST(SurfaceConstruction, says_what_it_cannot_make) {
    const auto message = [](const EnhancedReebGraph& graph) {
        try {
            construct_surface(graph);
            return std::string("nothing");
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
    };
    const auto pass = graph_of({{0, 0, 0}, {0, 0, 2}, {0, 0, 4}},
                               {{0, 1, {circle(0, 0, 1, 1)}}, {1, 2, {circle(0, 0, 3, 1)}}});
    EXPECT_NE(message(pass).find("node 1: one edge ends and one starts"), std::string::npos) << message(pass);
    const auto ring = graph_of({{0, 0, 0}, {0, 0, 3}, {4, 0, 3.5}},
                               {{0, 1, {circle(0, 0, 1, 1)}}, {0, 2, {circle(4, 0, 1, 1)}}});
    EXPECT_NE(message(ring).find("node 0: two edges start"), std::string::npos) << message(ring);
}

}  // namespace
}  // namespace stratareeb
