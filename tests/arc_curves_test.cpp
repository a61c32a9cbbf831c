// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

TEST(CenterOf, is_the_centroid_of_the_line) {
    const Contour square{.points = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}, .closed = true};
    EXPECT_NEAR(center_of(square).x, 1, 1e-15);
    EXPECT_NEAR(center_of(square).y, 1, 1e-15);
    // More points on one side change nothing: pieces weigh their lengths.
    const Contour uneven{.points = {{0, 0, 5}, {0.1, 0, 5}, {0.2, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}},
                         .closed = true};
    EXPECT_NEAR(center_of(uneven).x, 1, 1e-15);
    const Contour angle{.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, .closed = false};
    EXPECT_NEAR(center_of(angle).x, 1.5, 1e-15);
    EXPECT_NEAR(center_of(angle).y, 0.5, 1e-15);
    const Contour point{.points = {{7, 8, 9}}, .closed = true};
    EXPECT_EQ(center_of(point), (Point3{7, 8, 9}));
}

TEST(CenterOf, keeps_its_digits_far_from_zero) {
    const double east = 5e6, north = 6e6;
    const Contour square{
        .points = {{east, north, 1}, {east + 2, north, 1}, {east + 2, north + 2, 1}, {east, north + 2, 1}},
        .closed = true};
    EXPECT_EQ(center_of(square), (Point3{east + 1, north + 1, 1}));
}

// A ring standing upright: both arcs of its handle follow the circle in the middle of the tube.
TEST(ArcCurves, run_through_the_middle_of_tubes) {
    const double R = 3, r = 0.5;
    const TriMesh mesh = half_edge_mesh(shapes::torus(R, r, 90, 45));
    const ScalarField field = height_field(mesh, {1, 0, 0});
    const ReebGraph graph = reeb_graph(mesh, field);
    const ArcIndex index(mesh, field, graph);
    const auto curves = arc_curves(mesh, graph, index, 15);
    ASSERT_EQ(curves.size(), graph.arcs.size());
    std::size_t in_tube = 0;
    for (std::size_t a = 0; a < curves.size(); ++a) {
        const ReebNode &lower = graph.nodes[graph.arcs[a].lower], &upper = graph.nodes[graph.arcs[a].upper];
        const auto from = mesh.point(TriMesh::VertexHandle(static_cast<int>(lower.vertex)));
        EXPECT_EQ(curves[a].front(), (Point3{from[0], from[1], from[2]}));
        for (std::size_t k = 1; k < curves[a].size(); ++k)
            EXPECT_GE(curves[a][k].x, curves[a][k - 1].x) << "values rise along an arc";
        if (upper.value - lower.value < R) continue;  // the caps below and above the hole
        for (std::size_t k = 5; k + 5 < curves[a].size(); ++k) {
            const Point3& p = curves[a][k];
            EXPECT_NEAR(std::hypot(p.x, p.y), R, 0.1);
            EXPECT_NEAR(p.z, 0, 1e-3);
            ++in_tube;
        }
    }
    EXPECT_EQ(in_tube, 2 * 7u);
}

TEST(ArcCurves, of_level_arcs_are_straight) {
    const TriMesh mesh = half_edge_mesh(shapes::cube());
    const ScalarField field(mesh.n_vertices(), 1.0);
    const ReebGraph graph = reeb_graph(mesh, field);
    const ArcIndex index(mesh, field, graph);
    for (const auto& curve : arc_curves(mesh, graph, index)) EXPECT_EQ(curve.size(), 2u);
}

}  // namespace
}  // namespace stratareeb
