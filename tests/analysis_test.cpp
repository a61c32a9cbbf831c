// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "boreholes/errors.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using shapes::Index;

std::string problems(const MeshReport& report) {
    std::string all;
    for (const auto& problem : report.problems) all += problem + "\n";
    return all;
}

// The same shape with vertices, triangles and their first corners in any order.
TriangleSoup shuffled(const TriangleSoup& soup, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Index> number(soup.points.size());
    for (Index v = 0; v < number.size(); ++v) number[v] = v;
    std::shuffle(number.begin(), number.end(), random);
    TriangleSoup result;
    result.points.resize(soup.points.size());
    for (std::size_t v = 0; v < number.size(); ++v) result.points[number[v]] = soup.points[v];
    for (const auto& t : soup.triangles) {
        std::array<Index, 3> turned{number[t[0]], number[t[1]], number[t[2]]};
        std::rotate(turned.begin(), turned.begin() + static_cast<int>(random() % 3), turned.end());
        result.triangles.push_back(turned);
    }
    std::shuffle(result.triangles.begin(), result.triangles.end(), random);
    return result;
}

TEST(Analysis, finds_every_sound_solid_watertight) {
    for (const auto& shape : shapes::solids()) {
        const auto r = analyze(shape.soup);
        EXPECT_TRUE(r.watertight) << shape.name << "\n" << problems(r);
        EXPECT_TRUE(r.problems.empty()) << shape.name;
        EXPECT_TRUE(r.closed && r.manifold && r.oriented && r.orientable) << shape.name;
        EXPECT_EQ(r.boundary_loops, 0u);
    }
}

TEST(Analysis, volume_and_area_are_those_of_the_closed_form) {
    EXPECT_NEAR(analyze(shapes::slab(3, 2, 0.5)).volume, 3.0, 1e-12);
    EXPECT_NEAR(analyze(shapes::slab(3, 2, 0.5)).area, 2 * (6 + 1.5 + 1), 1e-12);
    EXPECT_NEAR(analyze(shapes::wedge(3, 2, 1)).volume, 3.0, 1e-12);
    EXPECT_NEAR(analyze(shapes::wedge(3, 2, 1)).area, 6 + 2 * std::sqrt(10.0) + 2 + 3, 1e-12);
    EXPECT_NEAR(analyze(shapes::tetrahedron()).volume, 1.0 / 6, 1e-15);
    EXPECT_NEAR(analyze(shapes::tetrahedron()).area, 1.5 + std::sqrt(3.0) / 2, 1e-12);
    for (Index n : {3u, 5u, 8u, 100u}) {
        const double corner = 2 * std::numbers::pi / n, base = n * 4 * std::sin(corner) / 2;
        EXPECT_NEAR(analyze(shapes::prism(n, 2, 3)).volume, 3 * base, 1e-11);
        EXPECT_NEAR(analyze(shapes::prism(n, 2, 3)).area, 2 * base + 3 * n * 4 * std::sin(corner / 2), 1e-11);
        EXPECT_NEAR(analyze(shapes::annulus(n, 1, 2)).area, (4 - 1) * n * std::sin(corner) / 2, 1e-11);
    }
    const auto bumpy = [](double x, double y) { return std::sin(x) * std::cos(2 * y); };
    EXPECT_NEAR(analyze(shapes::terrain_solid(20, 2.5, bumpy)).volume, 400 * 2.5, 1e-9);
}

TEST(Analysis, volume_converges_to_round_bodies) {
    const double sphere = 4.0 / 3 * std::numbers::pi * 8, torus = 2 * std::numbers::pi * std::numbers::pi * 3;
    double sphere_error = 1, torus_error = 1;
    for (Index n : {16u, 32u, 64u}) {
        const double s = 1 - analyze(shapes::uv_sphere(2, n, 2 * n)).volume / sphere;
        const double t = 1 - analyze(shapes::torus(3, 1, 2 * n, n)).volume / torus;
        EXPECT_LT(std::abs(s), sphere_error / (n == 16 ? 1 : 3.9));  // second order: a quarter each time
        EXPECT_LT(std::abs(t), torus_error / (n == 16 ? 1 : 3.9));
        sphere_error = std::abs(s);
        torus_error = std::abs(t);
    }
}

TEST(Analysis, volume_keeps_its_digits_far_from_the_origin) {
    const auto near =
        shapes::terrain_solid(30, 0.25, [](double x, double y) { return std::round(x * y) / 16; });
    const auto far = shapes::moved(near, 500000, 5000000, 1024);  // all coordinates still exact
    EXPECT_NEAR(volume(near), 225.0, 1e-10);
    EXPECT_NEAR(volume(far), 225.0, 1e-10);
    EXPECT_EQ(area(far), area(near));
}

TEST(Analysis, genus_and_euler_characteristic_follow_the_holes) {
    for (Index holes = 0; holes < 8; ++holes) {
        const auto r = analyze(shapes::plate_with_holes(holes));
        EXPECT_EQ(r.genus, holes);
        EXPECT_EQ(r.euler, 2 - 2 * static_cast<long long>(holes));
        EXPECT_NEAR(r.volume, 3.0 * (2 * holes + 1) - holes, 1e-12);
        EXPECT_TRUE(r.watertight);
    }
    const auto both =
        analyze(shapes::joined(shapes::torus(3, 1, 12, 8), shapes::moved(shapes::double_torus(), 9, 0, 0)));
    EXPECT_EQ(both.components, 2u);
    EXPECT_EQ(both.genus, 3u);  // summed over components
}

TEST(Analysis, boundary_loops_are_counted_and_filled_for_the_genus) {
    const std::pair<TriangleSoup, std::size_t> cases[] = {{shapes::disc(11, 2), 1},
                                                          {shapes::annulus(10, 1, 2), 2},
                                                          {shapes::cylinder(9, 1, 2), 2},
                                                          {shapes::terrain(9), 1}};
    for (const auto& [soup, loops] : cases) {
        const auto r = analyze(soup);
        EXPECT_EQ(r.boundary_loops, loops);
        EXPECT_EQ(r.genus, 0u);
        EXPECT_FALSE(r.closed);
        EXPECT_TRUE(r.manifold && r.oriented);
        EXPECT_FALSE(r.watertight);
        EXPECT_NE(problems(r).find("on one side only"), std::string::npos);
    }
    auto open_torus = shapes::torus(3, 1, 12, 8);
    open_torus.triangles.erase(open_torus.triangles.begin() + 40);
    open_torus.triangles.erase(open_torus.triangles.begin() + 3);
    EXPECT_EQ(analyze(open_torus).boundary_loops, 2u);
    EXPECT_EQ(analyze(open_torus).genus, 1u);
}

TEST(Analysis, fans_that_touch_in_a_vertex_are_taken_apart_for_the_loops) {
    TriangleSoup bow_tie;
    bow_tie.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    bow_tie.triangles = {{0, 1, 2}, {0, 3, 4}};
    EXPECT_EQ(analyze(bow_tie).boundary_loops, 2u);
    EXPECT_EQ(analyze(bow_tie).components, 1u);

    auto sphere = shapes::uv_sphere(1, 8, 12);
    sphere.triangles.erase(sphere.triangles.begin() + 6);  // two of the twelve around the pole
    sphere.triangles.erase(sphere.triangles.begin());
    const auto r = analyze(sphere);
    EXPECT_EQ(r.boundary_loops, 1u);         // cut the pole in two, and the two holes are one
    EXPECT_EQ(r.non_manifold_vertices, 1u);  // the pole
    EXPECT_FALSE(r.manifold);
    EXPECT_FALSE(r.genus.has_value());
}

TEST(Analysis, mobius_band_is_told_apart_from_bad_winding) {
    const auto band = analyze(shapes::mobius(40));
    EXPECT_TRUE(band.manifold);
    EXPECT_FALSE(band.oriented);
    EXPECT_FALSE(band.orientable);
    EXPECT_FALSE(band.genus.has_value());
    EXPECT_EQ(band.boundary_loops, 1u);
    EXPECT_NE(problems(band).find("one side only (not orientable)"), std::string::npos);

    auto turned = shapes::torus(3, 1, 12, 8);
    for (std::size_t t = 0; t < 50; ++t) std::swap(turned.triangles[t][0], turned.triangles[t][1]);
    const auto r = analyze(turned);
    EXPECT_FALSE(r.oriented);
    EXPECT_TRUE(r.orientable);
    EXPECT_EQ(r.genus, 1u);
    EXPECT_GT(r.misoriented_edges, 0u);
    EXPECT_FALSE(r.watertight);
}

TEST(Analysis, inside_out_bodies_are_not_watertight) {
    const auto r = analyze(shapes::turned_over(shapes::cube()));
    EXPECT_NEAR(r.volume, -1.0, 1e-15);
    EXPECT_TRUE(r.closed && r.manifold && r.oriented);
    EXPECT_EQ(r.inverted_components, 1u);
    EXPECT_FALSE(r.watertight);
    // One of two: the sum alone would not show it.
    const auto mixed =
        shapes::joined(shapes::slab(9, 9, 9), shapes::moved(shapes::turned_over(shapes::cube()), 20, 0, 0));
    EXPECT_GT(analyze(mixed).volume, 0);
    EXPECT_FALSE(analyze(mixed).watertight);
}

TEST(Analysis, small_bodies_far_from_large_ones_are_not_taken_for_flat) {
    for (int k = 0; k < 40; ++k) {
        TriangleSoup small = shapes::cube();
        for (Point3& p : small.points)
            p = {15772.4 + k + 1e-7 * p.x, 16584.3 - 0.7 * k + 1e-7 * p.y, -11.5 + 1e-7 * p.z};
        const auto right = analyze(shapes::joined(shapes::cube(), small));
        EXPECT_EQ(right.inverted_components, 0u) << k;
        EXPECT_TRUE(right.watertight) << k;
        EXPECT_EQ(analyze(shapes::joined(shapes::cube(), shapes::turned_over(small))).inverted_components, 1u)
            << k;
    }
}

TEST(Analysis, non_manifold_edges_and_vertices_are_counted_and_named) {
    auto wing = shapes::cube();
    wing.points.push_back({-1, -1, 0.5});
    wing.triangles.push_back({0, 4, 8});
    const auto r = analyze(wing);
    EXPECT_EQ(r.non_manifold_edges, 1u);
    EXPECT_EQ(r.boundary_edges, 2u);
    EXPECT_FALSE(r.manifold);
    EXPECT_NE(problems(r).find("from (0, 0, 1) to (0, 0, 0)"), std::string::npos) << problems(r);

    // Two cubes that share one edge: four triangles there, closed all the same.
    auto edge = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 1, 1, 0));
    for (auto& t : edge.triangles)
        for (auto& v : t) v = v == 8 ? 2 : v == 12 ? 6 : v;
    const auto two = analyze(edge);
    EXPECT_TRUE(two.closed);
    EXPECT_TRUE(two.oriented);
    EXPECT_EQ(two.non_manifold_edges, 1u);
    EXPECT_EQ(two.unused_vertices, 2u);
    EXPECT_EQ(two.self_intersections, 0u);
    EXPECT_FALSE(two.watertight);

    // Two cubes that share one corner.
    auto corner = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 1, 1, 1));
    for (auto& t : corner.triangles)
        for (auto& v : t) v = v == 8 ? 6 : v;
    const auto tip = analyze(corner);
    EXPECT_TRUE(tip.closed);
    EXPECT_EQ(tip.non_manifold_edges, 0u);
    EXPECT_EQ(tip.non_manifold_vertices, 1u);
    EXPECT_EQ(tip.components, 1u);
    EXPECT_FALSE(tip.watertight);
}

TEST(Analysis, duplicate_triangles_are_not_manifold_and_intersect) {
    auto soup = shapes::cube();
    soup.triangles.push_back(soup.triangles[5]);
    const auto r = analyze(soup);
    EXPECT_FALSE(r.manifold);
    EXPECT_GE(r.self_intersections, 1u);
    EXPECT_GE(r.non_manifold_edges, 3u);
    EXPECT_FALSE(r.watertight);
}

TEST(Analysis, degenerate_triangles_are_found_exactly) {
    auto soup = shapes::cube();
    soup.points.push_back({0.3, 0.3, 0.3});
    soup.triangles.push_back({0, 0, 1});
    soup.triangles.push_back({0, 6, 8});  // on the diagonal, as exactly as 0.3 = 0.3
    const auto r = analyze(soup);
    EXPECT_EQ(r.degenerate_triangles, 2u);
    EXPECT_FALSE(r.watertight);
    soup.points.back().z = std::nextafter(0.3, 1.0);
    EXPECT_EQ(analyze(soup).degenerate_triangles, 1u);

    auto needle = shapes::cube();  // closed, manifold, but with a needle without area in an edge
    needle.points.push_back({0.5, 0, 0});
    const auto broken = std::find_if(needle.triangles.begin(), needle.triangles.end(), [](const auto& t) {
        return std::count(t.begin(), t.end(), 0u) == 1 && std::count(t.begin(), t.end(), 1u) == 1;
    });
    ASSERT_NE(broken, needle.triangles.end());
    while (!((*broken)[0] < 2 && (*broken)[1] < 2))
        std::rotate(broken->begin(), broken->begin() + 1, broken->end());
    const auto [a, b, c] = *broken;
    *broken = {a, 8, c};
    needle.triangles.push_back({8, b, c});
    needle.triangles.push_back({b, 8, a});
    const auto n = analyze(needle);
    EXPECT_TRUE(n.closed && n.manifold && n.oriented) << problems(n);
    EXPECT_EQ(n.degenerate_triangles, 1u);
    EXPECT_EQ(n.self_intersections, 2u);  // across the needle, which is left out, its neighbours touch
    EXPECT_TRUE(std::isinf(n.worst_aspect_ratio));
    EXPECT_FALSE(n.watertight);
}

TEST(Analysis, self_intersecting_bodies_are_not_watertight) {
    const auto r = analyze(shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 0.5, 0.4, 0.3)));
    EXPECT_TRUE(r.closed && r.manifold && r.oriented);
    EXPECT_GT(r.self_intersections, 0u);
    EXPECT_FALSE(r.watertight);
    EXPECT_NE(problems(r).find("intersect"), std::string::npos);
}

TEST(Analysis, edges_angles_and_the_worst_triangle_are_measured) {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {100, 0, 0}, {200, 0, 0}, {150, 1, 0}};
    soup.triangles = {{0, 1, 2}, {3, 4, 5}};
    const auto r = analyze(soup);
    EXPECT_DOUBLE_EQ(r.min_edge, 3);
    EXPECT_DOUBLE_EQ(r.max_edge, 100);
    EXPECT_NEAR(r.min_angle_deg, std::atan(1.0 / 50) * 180 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(r.max_angle_deg, 180 - 2 * r.min_angle_deg, 1e-12);
    EXPECT_EQ(r.worst_triangle, 1u);
    EXPECT_NEAR(r.worst_aspect_ratio, 100, 1e-12);
    EXPECT_NEAR(r.worst_place.x, 150, 1e-12);
    EXPECT_EQ(r.box_min, (Point3{0, 0, 0}));
    EXPECT_EQ(r.box_max, (Point3{200, 4, 0}));
    TriangleSoup equilateral;
    equilateral.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    equilateral.triangles = {{0, 1, 2}};
    EXPECT_NEAR(analyze(equilateral).worst_aspect_ratio, 2 / std::sqrt(3.0), 1e-12);
}

TEST(Analysis, does_not_depend_on_the_order_of_anything) {
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) all.push_back(shape);
    all.push_back({"mobius", shapes::mobius(20)});
    for (const auto& shape : all) {
        const auto r = analyze(shape.soup);
        for (unsigned seed = 0; seed < 5; ++seed) {
            const auto s = analyze(shuffled(shape.soup, seed));
            EXPECT_EQ(s.euler, r.euler) << shape.name;
            EXPECT_EQ(s.genus, r.genus) << shape.name;
            EXPECT_EQ(s.components, r.components) << shape.name;
            EXPECT_EQ(s.boundary_loops, r.boundary_loops) << shape.name;
            EXPECT_EQ(s.orientable, r.orientable) << shape.name;
            EXPECT_EQ(s.watertight, r.watertight) << shape.name;
            EXPECT_NEAR(s.area, r.area, 1e-9 * r.area) << shape.name;
            if (!r.closed) continue;
            EXPECT_NEAR(s.volume, r.volume, 1e-9 * std::abs(r.volume)) << shape.name;
        }
    }
}

TEST(Analysis, of_nothing_and_of_one_triangle_is_defined) {
    const auto nothing = analyze(TriangleSoup{});
    EXPECT_FALSE(nothing.watertight || nothing.closed || nothing.manifold || nothing.oriented);
    EXPECT_EQ(problems(nothing), "there are no triangles\n");
    const auto one = analyze(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}});
    EXPECT_EQ(one.vertices, 4u);
    EXPECT_EQ(one.unused_vertices, 1u);
    EXPECT_EQ(one.components, 1u);
    EXPECT_EQ(one.boundary_loops, 1u);
    EXPECT_EQ(one.genus, 0u);
    EXPECT_TRUE(one.manifold && one.oriented);
    EXPECT_THROW(analyze(TriangleSoup{{{0, 0, 0}}, {{0, 1, 2}}}), InvalidInput);
}

TEST(Analysis, says_the_same_of_a_half_edge_mesh) {
    const auto mesh = half_edge_mesh(shapes::double_torus());
    EXPECT_EQ(analyze(mesh).genus, 2u);
    EXPECT_TRUE(analyze(mesh).watertight);
    EXPECT_NEAR(volume(mesh), 13, 1e-12);
    EXPECT_DOUBLE_EQ(area(mesh), analyze(mesh).area);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_FALSE(is_closed(half_edge_mesh(shapes::terrain(3))));
    EXPECT_FALSE(is_closed(TriMesh{}));
}

}  // namespace
}  // namespace stratareeb
