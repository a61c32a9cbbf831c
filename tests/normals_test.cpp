// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

constexpr NormalWeight kWeights[] = {NormalWeight::Uniform, NormalWeight::Area, NormalWeight::Angle};

void expect_near(const Point3& n, const Point3& expected, double tolerance) {
    EXPECT_NEAR(n.x, expected.x, tolerance);
    EXPECT_NEAR(n.y, expected.y, tolerance);
    EXPECT_NEAR(n.z, expected.z, tolerance);
}

TEST(Normals, have_length_one_on_every_shape) {
    for (const auto weight : kWeights)
        for (const auto& shape : shapes::solids())
            for (const auto& n : vertex_normals(shape.soup, weight))
                EXPECT_NEAR(std::hypot(n.x, n.y, n.z), 1.0, 1e-12) << shape.name;
}

TEST(Normals, of_a_plane_are_its_normal) {
    const auto plane = shapes::terrain(5, [](double x, double y) { return 0.25 * x - 0.5 * y; });
    const double length = std::hypot(0.25, 0.5, 1.0);
    for (const auto weight : kWeights)
        for (const auto& n : vertex_normals(plane, weight))
            expect_near(n, {-0.25 / length, 0.5 / length, 1 / length}, 1e-12);
}

TEST(Normals, uniform_is_the_plain_average_of_face_normals) {
    // At vertex 0 of the tetrahedron: the faces x = 0, y = 0 and z = 0, seen from outside.
    expect_near(vertex_normals(shapes::tetrahedron())[0],
                {-std::sqrt(1.0 / 3), -std::sqrt(1.0 / 3), -std::sqrt(1.0 / 3)}, 1e-12);
    // At vertex 0 of the slab three sides meet with 2, 1 and 2 triangles, or 1 + 1 + 2, as the diagonals
    // fall.
    const auto slab = shapes::slab(4, 2, 1);
    int below = 0, front = 0, left = 0;
    for (const auto& t : slab.triangles) {
        if (t[0] != 0 && t[1] != 0 && t[2] != 0) continue;
        const auto is_on = [&](auto coordinate) {
            return coordinate(slab.points[t[0]]) == 0 && coordinate(slab.points[t[1]]) == 0 &&
                   coordinate(slab.points[t[2]]) == 0;
        };
        below += is_on([](const Point3& p) { return p.z; });
        front += is_on([](const Point3& p) { return p.y; });
        left += is_on([](const Point3& p) { return p.x; });
    }
    const double length = std::hypot(below, front, left);
    expect_near(vertex_normals(slab)[0], {-left / length, -front / length, -below / length}, 1e-12);
}

TEST(Normals, weights_differ_where_faces_differ) {
    const auto slab = shapes::slab(4, 2, 1);
    const double third = std::sqrt(1.0 / 3);
    for (const auto& n : vertex_normals(slab, NormalWeight::Angle)) {  // a right angle on each of three sides
        EXPECT_NEAR(std::abs(n.x), third, 1e-12);
        EXPECT_NEAR(std::abs(n.y), third, 1e-12);
        EXPECT_NEAR(std::abs(n.z), third, 1e-12);
    }
    const auto area = vertex_normals(shapes::tetrahedron(), NormalWeight::Area)[1];
    // Around (1,0,0): faces y = 0 and z = 0 of area 1/2 and the slanted one, whose area vector is (1,1,1)/2.
    // They sum to (1,0,0)/2.
    expect_near(area, {1, 0, 0}, 1e-12);
}

TEST(Normals, on_a_sphere_point_away_from_its_centre) {
    const auto sphere = shapes::uv_sphere(2, 60, 120);
    const auto normals = vertex_normals(sphere, NormalWeight::Angle);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const auto& p = sphere.points[v];
        EXPECT_GT((normals[v].x * p.x + normals[v].y * p.y + normals[v].z * p.z) / 2, 0.999);
    }
}

TEST(Normals, of_vertices_without_a_direction_are_defined) {
    TriangleSoup soup = shapes::tetrahedron();
    soup.points.push_back({9, 9, 9});
    EXPECT_EQ(vertex_normals(soup)[4], (Point3{0, 0, 1}));  // no faces: up

    TriangleSoup pillow;  // two faces back to back cancel out: the first one counts
    pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    pillow.triangles = {{0, 2, 1}, {0, 1, 2}};
    for (const auto weight : kWeights)
        for (const auto& n : vertex_normals(pillow, weight)) expect_near(n, {0, 0, -1}, 1e-12);

    TriangleSoup needle;  // no area: no direction
    needle.points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    needle.triangles = {{0, 1, 2}, {0, 0, 1}};
    for (const auto& n : vertex_normals(needle)) EXPECT_EQ(n, (Point3{0, 0, 1}));
}

TEST(Normals, do_not_depend_on_scale_or_place) {
    const auto near = shapes::torus(3, 1, 20, 10);
    const auto expected = vertex_normals(near);
    for (const double scale : {1e-120, 1e-9, 1e9, 1e120}) {
        auto scaled = near;
        for (auto& p : scaled.points) p = {p.x * scale, p.y * scale, p.z * scale};
        const auto normals = vertex_normals(scaled);
        for (std::size_t v = 0; v < normals.size(); ++v) expect_near(normals[v], expected[v], 1e-9);
    }
    const auto far = vertex_normals(shapes::moved(near, 5e6, 5e6, 0));
    for (std::size_t v = 0; v < far.size(); ++v) expect_near(far[v], expected[v], 1e-7);
}

TEST(Normals, are_set_on_a_half_edge_mesh) {
    const auto soup = shapes::torus(3, 1, 20, 10);
    auto mesh = half_edge_mesh(soup);
    update_vertex_normals(mesh, NormalWeight::Area);
    const auto expected = vertex_normals(soup, NormalWeight::Area);
    for (const auto v : mesh.vertices()) {
        const auto n = mesh.normal(v);
        EXPECT_EQ((Point3{n[0], n[1], n[2]}), expected[static_cast<std::size_t>(v.idx())]);
    }
}

}  // namespace
}  // namespace stratareeb
