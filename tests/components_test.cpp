// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/components.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/analysis.h"
#include "mesh/normals.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

TEST(Components, of_one_body_are_that_body) {
    const auto torus = shapes::torus(3, 1, 12, 8);
    const auto parts = connected_components(torus);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].points, torus.points);
    EXPECT_EQ(parts[0].triangles, torus.triangles);
    EXPECT_TRUE(connected_components(TriangleSoup{}).empty());
}

TEST(Components, come_in_the_order_of_their_first_triangles_with_their_volumes) {
    auto soup = shapes::joined(shapes::joined(shapes::cube(), shapes::moved(shapes::tetrahedron(), 3, 0, 0)),
                               shapes::moved(shapes::slab(2, 2, 2), 9, 0, 0));
    std::rotate(soup.triangles.begin(), soup.triangles.begin() + 12,
                soup.triangles.end());       // the tetrahedron first
    soup.points.push_back({100, 100, 100});  // belongs to none
    const auto parts = connected_components(half_edge_mesh(soup));
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(volume(parts[0]), 1.0 / 6, 1e-12);
    EXPECT_NEAR(volume(parts[1]), 8.0, 1e-12);
    EXPECT_NEAR(volume(parts[2]), 1.0, 1e-12);
    for (const auto& part : parts) EXPECT_TRUE(analyze(part).watertight);
}

TEST(Components, are_found_however_vertices_are_interleaved) {
    TriangleSoup soup;  // vertex i of tetrahedron k is number 3i + k
    const auto one = shapes::tetrahedron();
    for (const auto& p : one.points)
        for (int k = 0; k < 3; ++k) soup.points.push_back({p.x + 2 * k, p.y, p.z});
    for (const auto& t : one.triangles)
        for (std::uint32_t k = 0; k < 3; ++k)
            soup.triangles.push_back({3 * t[0] + k, 3 * t[1] + k, 3 * t[2] + k});
    const auto parts = connected_components(soup);
    ASSERT_EQ(parts.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(parts[k].triangles, one.triangles);
        EXPECT_EQ(parts[k].points[0].x, 2.0 * static_cast<double>(k));
    }
}

TEST(Components, take_their_normals_along) {
    auto mesh = half_edge_mesh(shapes::two_components());
    update_vertex_normals(mesh, NormalWeight::Area);
    std::vector<TriMesh::Normal> normals;
    for (const auto& part : connected_components(mesh))
        for (const auto v : part.vertices()) normals.push_back(part.normal(v));
    ASSERT_EQ(normals.size(), mesh.n_vertices());
    for (const auto v : mesh.vertices())
        EXPECT_EQ(normals[static_cast<std::size_t>(v.idx())], mesh.normal(v));
}

}  // namespace
}  // namespace stratareeb
