// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/loop_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mesh/analysis.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

TEST(LoopHandles, there_is_one_for_each_handle_of_a_plate) {
    const TriMesh mesh = half_edge_mesh(shapes::plate_with_holes(4));
    // Along the row of holes; the slant keeps all values apart, so that each hole opens and closes at a vertex.
    const ReebGraph graph = reeb_graph(mesh, height_field(mesh, {1, 0.01, 0.001}));
    const auto handles = loop_handles(mesh, graph);
    ASSERT_EQ(handles.size(), 4u);
    std::set<int> holes;
    for (const LoopHandle& handle : handles) {
        EXPECT_FALSE(handle.triangles.empty());
        EXPECT_TRUE(std::ranges::is_sorted(handle.triangles));
        // Hole i is the cell from x = 2i + 1 to 2i + 2; the bar beside it reaches about from and to there.
        const double middle = (handle.box_min.x + handle.box_max.x) / 2;
        holes.insert(static_cast<int>(std::floor((middle - 1) / 2)));
        EXPECT_LE(handle.box_max.x - handle.box_min.x, 3);
        for (const std::uint32_t t : handle.triangles) {
            const std::uint32_t arc = graph.triangle_arc[t];
            EXPECT_TRUE(std::ranges::count(handle.cycle.sides[0], arc) ||
                        std::ranges::count(handle.cycle.sides[1], arc));
        }
    }
    EXPECT_EQ(holes, (std::set<int>{0, 1, 2, 3}));
}

TEST(LoopHandles, a_handle_is_the_smaller_side) {
    const TriMesh mesh = half_edge_mesh(shapes::torus(3, 1, 60, 30));
    const ReebGraph graph = reeb_graph(mesh, height_field(mesh, {1, 0.1, 0.05}));
    const auto handles = loop_handles(mesh, graph);
    ASSERT_EQ(handles.size(), 1u);
    std::array<std::size_t, 2> count{};
    for (int side = 0; side < 2; ++side)
        for (const std::uint32_t arc : handles[0].cycle.sides[side])
            count[side] += static_cast<std::size_t>(std::ranges::count(graph.triangle_arc, arc));
    EXPECT_EQ(handles[0].triangles.size(), std::min(count[0], count[1]));
}

TEST(LoopHandles, spheres_and_nothing_have_none) {
    const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(1, 9, 12));
    EXPECT_TRUE(loop_handles(sphere, reeb_graph(sphere, height_field(sphere))).empty());
    EXPECT_TRUE(loop_handles(TriMesh(), {}).empty());
}

}  // namespace
}  // namespace stratareeb
