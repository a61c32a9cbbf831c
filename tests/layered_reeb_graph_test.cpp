// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/layered_reeb_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "mesh/triangle_soup.h"
#include "reeb/reeb_graph.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

struct Surfaces {
    std::deque<TriMesh> meshes;
    std::deque<ScalarField> fields;
    std::vector<LayerSurface> layers;

    void add(const TriangleSoup& soup, const Point3& direction = {0, 0, 1}) {
        meshes.push_back(half_edge_mesh(soup));
        fields.push_back(height_field(meshes.back(), direction));
        layers.push_back({&meshes.back(), &fields.back()});
    }
};

std::size_t arcs_of(const LayeredReebGraph& graph, std::uint32_t layer) {
    return static_cast<std::size_t>(
        std::ranges::count_if(graph.arcs, [&](const LayeredArc& arc) { return arc.layer == layer; }));
}

// Two spheres, one twice as high up: each is seen at the other's critical heights.
TEST(LayeredReebGraph, of_two_spheres_has_nodes_at_the_heights_of_both) {
    Surfaces two;
    two.add(shapes::uv_sphere(1, 32, 32));                            // z from -1 to 1
    two.add(shapes::moved(shapes::uv_sphere(1, 32, 32), 5, 0, 0.5));  // from -0.5 to 1.5
    const LayeredReebGraph graph = layered_reeb_graph(two.layers);
    ASSERT_EQ(graph.nodes.size(), 4u);
    const std::vector<std::size_t> contours{1, 2, 2, 1};
    for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(graph.nodes[n].contours.size(), contours[n]) << n;
    EXPECT_DOUBLE_EQ(graph.nodes[1].value, -0.5);
    // At -0.5 the first is a circle around its axis, the second a point.
    EXPECT_NEAR(graph.nodes[1].contours[0].contour.length(), 2 * std::numbers::pi * std::sqrt(0.75), 0.05);
    EXPECT_NEAR(graph.nodes[1].contours[0].center.x, 0, 1e-12);
    EXPECT_EQ(graph.nodes[1].contours[1].contour.points.size(), 1u);
    EXPECT_NEAR(graph.nodes[1].center.x, 0, 1e-12) << "a point weighs nothing beside a circle";
    EXPECT_NEAR(graph.nodes[0].center.z, -1, 1e-12);
    EXPECT_EQ(arcs_of(graph, 0), 2u);
    EXPECT_EQ(arcs_of(graph, 1), 2u);
    for (const LayeredArc& arc : graph.arcs) EXPECT_LT(arc.lower, arc.upper);
}

TEST(LayeredReebGraph, of_one_surface_has_its_critical_heights) {
    Surfaces one;
    one.add(shapes::torus(3, 1, 24, 12), {1, 0, 0.01});
    const LayeredReebGraph graph = layered_reeb_graph(one.layers);
    const ReebGraph reeb = reeb_graph(one.meshes[0], one.fields[0]);
    ASSERT_EQ(graph.nodes.size(), reeb.nodes.size());
    EXPECT_EQ(graph.arcs.size(), graph.nodes.size() - 1);
    // Just below its upper saddle the torus is cut into two circles.
    EXPECT_EQ(graph.nodes[2].contours.size(), 2u);
}

TEST(LayeredReebGraph, leaves_a_gap_where_a_layer_has_nothing) {
    Surfaces pieces;
    pieces.add(
        shapes::joined(shapes::uv_sphere(1, 8, 8), shapes::moved(shapes::uv_sphere(1, 8, 8), 0, 0, 10)));
    const LayeredReebGraph graph = layered_reeb_graph(pieces.layers);
    ASSERT_EQ(graph.nodes.size(), 4u);
    ASSERT_EQ(graph.arcs.size(), 2u);
    EXPECT_EQ(graph.arcs[0].upper, 1u);
    EXPECT_EQ(graph.arcs[1].lower, 2u);
}

TEST(LayeredReebGraph, takes_further_levels_and_leaves_out_small_bumps) {
    const auto hills = [](double x, double y) { return 0.02 * std::sin(9 * x) * std::sin(7 * y) + x; };
    Surfaces layers;
    layers.add(shapes::terrain_solid(12, 1, hills));
    layers.add(shapes::terrain_solid(12, 2, hills));
    const auto whole = layered_reeb_graph(layers.layers);
    const auto coarse = layered_reeb_graph(layers.layers, {.simplify = 0.2, .further_levels = {}});
    EXPECT_LT(coarse.nodes.size(), whole.nodes.size());
    const auto more =
        layered_reeb_graph(layers.layers, {.simplify = 0.2, .further_levels = {3.25, 4.75, 1000}});
    EXPECT_EQ(more.nodes.size(), coarse.nodes.size() + 2) << "nothing at 1000";
    EXPECT_EQ(arcs_of(coarse, 1) + 1,
              static_cast<std::size_t>(std::ranges::count_if(coarse.nodes, [](const auto& n) {
                  return std::ranges::any_of(n.contours, [](const auto& c) { return c.layer == 1; });
              })));
    EXPECT_TRUE(layered_reeb_graph({}).nodes.empty());
}

}  // namespace
}  // namespace stratareeb
