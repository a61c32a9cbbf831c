// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/refine.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <string>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "tests/refine_cases.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using shapes::octahedron;
using shapes::quad_cube;
using shapes::quad_grid;
using shapes::quad_torus;
constexpr auto kLoop = SubdivisionScheme::Loop;
constexpr auto kCatmullClark = SubdivisionScheme::CatmullClark;

void expect_near(const Point3& a, const Point3& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

Point3 unit(const Point3& p) {
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x / length, p.y / length, p.z / length};
}

double volume_of(const PolygonMesh& mesh) {
    return volume(triangle_fans(mesh));
}
double area_of(const PolygonMesh& mesh) {
    return area(triangle_fans(mesh));
}

// Sum of w_vertex * vertex + w_edge * edge neighbours + w_face * face neighbours.
Point3 mask(const PolygonMesh& mesh, const shapes::Neighbours& around, std::size_t v, double w_vertex,
            double w_edge, double w_face) {
    Point3 sum;
    const auto add = [&](const Point3& p, double w) {
        sum = {sum.x + w * p.x, sum.y + w * p.y, sum.z + w * p.z};
    };
    add(mesh.points[v], w_vertex);
    for (const auto e : around.edges) add(mesh.points[e], w_edge);
    for (const auto f : around.faces) add(mesh.points[f], w_face);
    return sum;
}

PolygonMesh moved_at_random(PolygonMesh mesh, double by) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-by, by);
    for (auto& p : mesh.points) p = {p.x + uniform(random), p.y + uniform(random), p.z + uniform(random)};
    return mesh;
}

TEST(Refine, the_octahedron_has_the_limit_points_of_loops_mask) {
    // Loop 1987: beta = 31/256 for valence 4, so the limit keeps 24/55 of the vertex.
    for (int levels = 1; levels <= 5; ++levels) {
        const auto refined = refine(octahedron(), {.levels = levels});
        EXPECT_EQ(refined.mesh.face_count(), 8u << (2 * levels));
        for (std::size_t v = 0; v < 6; ++v) {
            const auto p = octahedron().points[v];
            expect_near(refined.mesh.points[v], {p.x * 24 / 55, p.y * 24 / 55, p.z * 24 / 55}, 1e-15);
            expect_near(refined.normals[v], p, 1e-14);
        }
    }
}

TEST(Refine, the_cube_has_the_limit_points_of_halsteads_mask) {
    // Halstead, Kass, DeRose 1993: (n^2 v + 4 sum of edge ends + sum of opposite corners) / (n (n + 5)).
    for (int levels = 1; levels <= 5; ++levels) {
        const auto refined = refine(quad_cube(), {.scheme = kCatmullClark, .levels = levels});
        EXPECT_EQ(refined.mesh.face_count(), 6u << (2 * levels));
        for (std::size_t v = 0; v < 8; ++v) {
            const auto p = quad_cube().points[v];
            expect_near(refined.mesh.points[v], {p.x / 2, p.y / 2, p.z / 2}, 1e-15);
            expect_near(refined.normals[v], unit(p), 1e-13);
        }
    }
}

TEST(Refine, regular_tori_have_the_limit_points_of_box_and_b_splines) {
    const auto quads = moved_at_random(quad_torus(5, 2, 9, 7), 0.3);
    auto around = shapes::neighbours(quads);
    const auto smooth_quads = refine(quads, {.scheme = kCatmullClark, .levels = 3});
    for (std::size_t v = 0; v < quads.points.size(); ++v)
        expect_near(smooth_quads.mesh.points[v], mask(quads, around[v], v, 16.0 / 36, 4.0 / 36, 1.0 / 36),
                    1e-14);

    const auto triangles = moved_at_random(polygon_mesh(shapes::torus(5, 2, 9, 7)), 0.3);
    around = shapes::neighbours(triangles);
    const auto smooth_triangles = refine(triangles, {.scheme = kLoop, .levels = 3});
    for (std::size_t v = 0; v < triangles.points.size(); ++v)
        expect_near(smooth_triangles.mesh.points[v], mask(triangles, around[v], v, 0.5, 1.0 / 12, 0), 1e-14);
}

TEST(Refine, vertices_of_any_valence_have_the_published_limit_points) {
    const auto sphere = moved_at_random(polygon_mesh(shapes::uv_sphere(1, 7, 11)), 0.05);
    auto around = shapes::neighbours(sphere);
    const auto loop = refine(sphere, {.levels = 2});
    for (std::size_t v = 0; v < sphere.points.size(); ++v) {
        const double n = static_cast<double>(around[v].edges.size());
        const double c = 0.375 + std::cos(2 * std::numbers::pi / n) / 4, beta = (0.625 - c * c) / n;
        const double w = 1 / (3 / (8 * beta) + n);
        expect_near(loop.mesh.points[v], mask(sphere, around[v], v, 1 - n * w, w, 0), 1e-14);
    }
    // One level of Catmull-Clark makes quads of all; its vertices have Halstead's limits.
    for (const std::uint32_t sides : {3u, 5u, 8u, 13u}) {
        const auto prism = moved_at_random(shapes::polygon_prism(sides, 2, 1), 0.1);
        const auto once = refine(prism, {.scheme = kCatmullClark, .levels = 1, .limit = false});
        const auto limit = refine(prism, {.scheme = kCatmullClark, .levels = 3});
        around = shapes::neighbours(once.mesh);
        for (std::size_t v = 0; v < once.mesh.points.size(); ++v) {
            const double n = static_cast<double>(around[v].edges.size()), whole = n * (n + 5);
            expect_near(limit.mesh.points[v],
                        mask(once.mesh, around[v], v, n * n / whole, 4 / whole, 1 / whole), 1e-13);
        }
    }
}

TEST(Refine, limit_points_do_not_depend_on_the_level) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto control = scheme == kLoop ? moved_at_random(polygon_mesh(shapes::double_torus()), 0.02)
                                             : moved_at_random(shapes::polygon_prism(7, 2, 1), 0.1);
        // A crease that ends inside, where OpenSubdiv's own limit is another point on each level.
        const RefineOptions options{
            .scheme = scheme, .levels = 1, .creases = {{control.corners[0], control.corners[1]}}};
        const auto once = refine(control, options);
        for (int levels = 2; levels <= 4; ++levels) {
            RefineOptions deeper = options;
            deeper.levels = levels;
            const auto refined = refine(control, deeper);
            for (std::size_t v = 0; v < once.mesh.points.size(); ++v)
                expect_near(refined.mesh.points[v], once.mesh.points[v], 1e-13);
        }
    }
}

TEST(Refine, a_plane_stays_a_plane_and_its_normal) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (const auto scheme : {kLoop, kCatmullClark})
        for (const auto boundary : {BoundaryRule::Smooth, BoundaryRule::SharpCorners, BoundaryRule::Fixed}) {
            PolygonMesh mesh = scheme == kLoop ? polygon_mesh(shapes::terrain(6)) : quad_grid(6);
            for (auto& p : mesh.points) {
                p.x += uniform(random);
                p.y += uniform(random);
                p.z = 0.25 * p.x - 0.5 * p.y + 7;
            }
            const auto refined = refine(mesh, {.scheme = scheme, .levels = 3, .boundary = boundary});
            for (std::size_t v = 0; v < refined.mesh.points.size(); ++v) {
                const auto& p = refined.mesh.points[v];
                EXPECT_NEAR(p.z, 0.25 * p.x - 0.5 * p.y + 7, 1e-13);
                expect_near(refined.normals[v], unit({-0.25, 0.5, 1}), 1e-11);
            }
        }
}

TEST(Refine, volumes_converge_by_a_quarter_a_level_to_those_of_sphere_and_torus) {
    struct Case {
        SubdivisionScheme scheme;
        PolygonMesh mesh;
        double exact;
    };
    const double torus = 2 * std::numbers::pi * std::numbers::pi * 3;
    const double sphere = 4 * std::numbers::pi / 3;
    const std::vector<Case> cases{{kLoop, polygon_mesh(shapes::torus(3, 1, 40, 20)), torus},
                                  {kCatmullClark, quad_torus(3, 1, 40, 20), torus},
                                  {kLoop, polygon_mesh(shapes::uv_sphere(1, 20, 30)), sphere},
                                  {kCatmullClark, polygon_mesh(shapes::uv_sphere(1, 20, 30)), sphere}};
    for (const auto& c : cases) {
        std::vector<double> volumes;
        for (int levels = 1; levels <= 4; ++levels)
            volumes.push_back(volume_of(refine(c.mesh, {.scheme = c.scheme, .levels = levels}).mesh));
        EXPECT_NEAR((volumes[2] - volumes[1]) / (volumes[1] - volumes[0]), 0.25, 0.02);
        EXPECT_NEAR((volumes[3] - volumes[2]) / (volumes[2] - volumes[1]), 0.25, 0.01);
        EXPECT_NEAR(volumes[3], c.exact, 0.05 * c.exact);  // the limit surface lies inside its control mesh
    }
}

TEST(Refine, normals_are_those_of_the_limit_surface) {
    // Against differences of positions: at every vertex of a fine level, the limit normal of a coarse one is the mean normal there.
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto control = scheme == kLoop ? moved_at_random(polygon_mesh(shapes::torus(5, 2, 9, 7)), 0.2)
                                             : moved_at_random(quad_torus(5, 2, 9, 7), 0.2);
        const auto coarse = refine(control, {.scheme = scheme, .levels = 1});
        const auto fine = refine(control, {.scheme = scheme, .levels = 6});
        const auto soup = triangle_fans(fine.mesh);
        std::vector<Point3> sums(soup.points.size());
        for (const auto& t : soup.triangles) {
            const auto &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
            const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, w{c.x - a.x, c.y - a.y, c.z - a.z};
            for (const auto v : t)
                sums[v] = {sums[v].x + u.y * w.z - u.z * w.y, sums[v].y + u.z * w.x - u.x * w.z,
                           sums[v].z + u.x * w.y - u.y * w.x};
        }
        for (std::size_t v = 0; v < coarse.normals.size(); ++v)
            expect_near(coarse.normals[v], unit(sums[v]), 0.01);
    }
}

TEST(Refine, fixed_outlines_stay_where_they_are) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto disc = polygon_mesh(shapes::disc(7, 2));
        const auto refined = refine(disc, {.scheme = scheme, .levels = 4, .boundary = BoundaryRule::Fixed});
        EXPECT_EQ(refined.corners, 7u);
        EXPECT_NEAR(area_of(refined.mesh), area_of(disc), 1e-13);
        for (std::size_t v = 1; v <= 7; ++v) expect_near(refined.mesh.points[v], disc.points[v], 1e-15);
        const auto report = analyze(triangle_fans(refined.mesh));
        EXPECT_EQ(report.boundary_edges, 7u << 4);
    }
}

TEST(Refine, corners_stay_and_sides_between_them_stay_straight) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto grid = scheme == kLoop ? polygon_mesh(triangle_fans(quad_grid(4))) : quad_grid(4);
        const auto refined = refine(grid, {.scheme = scheme, .levels = 3});
        EXPECT_EQ(refined.corners, 4u);
        EXPECT_NEAR(area_of(refined.mesh), 16, 1e-13);
        for (const auto corner : {0u, 4u, 20u, 24u})
            expect_near(refined.mesh.points[corner], grid.points[corner], 0);
        // A dodecagon turns by 30 degrees in each vertex: no corners by default, twelve for a smaller angle.
        const auto disc = polygon_mesh(shapes::disc(12, 1));
        EXPECT_EQ(refine(disc, {.scheme = scheme}).corners, 0u);
        EXPECT_EQ(refine(disc, {.scheme = scheme, .corner_angle_deg = 29}).corners, 12u);
        EXPECT_EQ(refine(disc, {.scheme = scheme, .corner_angle_deg = 31}).corners, 0u);
    }
}

TEST(Refine, smooth_outlines_are_cubic_b_splines) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto disc = polygon_mesh(shapes::disc(5, 1));
        const auto refined = refine(disc, {.scheme = scheme, .levels = 2, .boundary = BoundaryRule::Smooth});
        for (std::uint32_t i = 0; i < 5; ++i) {
            const auto &p = disc.points[1 + i], &a = disc.points[1 + (i + 1) % 5],
                       &b = disc.points[1 + (i + 4) % 5];
            expect_near(refined.mesh.points[1 + i],
                        {p.x * 2 / 3 + (a.x + b.x) / 6, p.y * 2 / 3 + (a.y + b.y) / 6, 0}, 1e-15);
        }
        const auto grid = scheme == kLoop ? polygon_mesh(triangle_fans(quad_grid(4))) : quad_grid(4);
        EXPECT_LT(area_of(refine(grid, {.scheme = scheme, .boundary = BoundaryRule::Smooth}).mesh), 16 - 0.1);
    }
}

TEST(Refine, creases_by_angle_keep_a_cube_a_cube) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const auto cube = scheme == kLoop ? polygon_mesh(triangle_fans(quad_cube())) : quad_cube();
        const auto refined = refine(cube, {.scheme = scheme, .levels = 3, .crease_angle_deg = 89});
        EXPECT_EQ(refined.creases, 12u);
        EXPECT_NEAR(volume_of(refined.mesh), 8, 1e-13);
        EXPECT_NEAR(area_of(refined.mesh), 24, 1e-12);
        expect_near(refined.normals[6], unit({1, 1, 1}), 1e-14);
        EXPECT_EQ(refine(cube, {.scheme = scheme, .levels = 1, .crease_angle_deg = 91}).creases, 0u);
    }
}

TEST(Refine, semi_sharp_creases_are_between_sharp_and_smooth) {
    double last = 0;
    for (const double sharpness : {0.0, 0.5, 1.0, 2.0, 3.0, kInfiniteSharpness}) {
        RefineOptions options{.scheme = kCatmullClark, .levels = 5};
        const auto cube = quad_cube();
        for_each_face(cube, [&](std::size_t, std::span<const std::uint32_t> c) {
            for (std::size_t i = 0; i < 4; ++i) options.creases.push_back({c[i], c[(i + 1) % 4], sharpness});
        });
        const double now = volume_of(refine(cube, options).mesh);
        EXPECT_GT(now, last + 0.05);
        last = now;
    }
    EXPECT_NEAR(last, 8, 1e-12);
}

TEST(Refine, sharp_corners_by_number_stay) {
    const auto refined = refine(octahedron(), {.levels = 3, .sharp_corners = {{4}}});
    expect_near(refined.mesh.points[4], {0, 0, 1}, 0);
    EXPECT_LT(std::abs(refined.mesh.points[5].z), 0.5);
}

TEST(Refine, topology_is_kept_for_every_solid) {
    for (const auto& shape : shapes::solids())
        for (const auto scheme : {kLoop, kCatmullClark}) {
            const auto before = analyze(shape.soup);
            const auto refined = refine(polygon_mesh(shape.soup), {.scheme = scheme, .levels = 2});
            const auto after = analyze(triangle_fans(refined.mesh), {.self_intersections = false});
            EXPECT_TRUE(after.closed && after.manifold && after.oriented) << shape.name;
            EXPECT_EQ(after.euler, before.euler) << shape.name;
            EXPECT_EQ(after.genus, before.genus) << shape.name;
            EXPECT_GT(after.volume, 0) << shape.name;
        }
}

TEST(Refine, far_from_the_origin_nothing_is_lost) {
    auto mesh = polygon_mesh(shapes::torus(3, 1, 20, 10));
    const double here = volume_of(refine(mesh, {.levels = 3}).mesh);
    for (auto& p : mesh.points) p = {p.x + 500'000, p.y + 5'000'000, p.z};
    EXPECT_NEAR(volume_of(refine(mesh, {.levels = 3}).mesh), here, 1e-6);
}

TEST(Refine, vertices_without_faces_stay) {
    auto mesh = octahedron();
    mesh.points.insert(mesh.points.begin() + 3, Point3{9, 8, 7});
    for (auto& c : mesh.corners) c += c >= 3 ? 1 : 0;
    const auto refined = refine(mesh, {.levels = 2});
    expect_near(refined.mesh.points[3], {9, 8, 7}, 0);
    expect_near(refined.mesh.points[5], {0, 0, 24.0 / 55}, 1e-15);
}

TEST(Refine, half_edge_meshes_come_back_as_such) {
    const TriMesh torus = half_edge_mesh(shapes::torus(3, 1, 12, 6));
    const TriMesh loop = refine(torus, {.levels = 2});
    EXPECT_EQ(loop.n_faces(), torus.n_faces() * 16);
    EXPECT_TRUE(is_closed(loop));
    EXPECT_NEAR(loop.normal(TriMesh::VertexHandle(0)).norm(), 1, 1e-12);
    EXPECT_EQ(refine(torus, {.scheme = kCatmullClark, .levels = 1}).n_faces(), torus.n_faces() * 6);
}

TEST(Refine, results_are_equal_with_any_number_of_threads) {
    const auto mesh = moved_at_random(polygon_mesh(shapes::torus(5, 2, 90, 70)), 0.05);
    const RefineOptions options{.levels = 2, .crease_angle_deg = 12};
    const auto all = refine(mesh, options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = refine(mesh, options);
    EXPECT_GT(all.creases, 100u);
    EXPECT_EQ(all.mesh.corners, alone.mesh.corners);
    EXPECT_EQ(std::memcmp(all.mesh.points.data(), alone.mesh.points.data(),
                          all.mesh.points.size() * sizeof(Point3)),
              0);
    EXPECT_EQ(std::memcmp(all.normals.data(), alone.normals.data(), all.normals.size() * sizeof(Point3)), 0);
}

std::string refusal(const PolygonMesh& mesh, const RefineOptions& options) {
    try {
        refine(mesh, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(Refine, what_is_no_manifold_is_refused_with_its_place) {
    for (const auto scheme : {kLoop, kCatmullClark}) {
        const RefineOptions options{.scheme = scheme};
        auto three = polygon_mesh(shapes::disc(3, 1));
        three.points.push_back({0, 0, 5});
        three.corners.insert(three.corners.end(), {0, 1, 4});
        EXPECT_NE(refusal(three, options)
                      .find("edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 0, 0) has 3 faces"),
                  std::string::npos)
            << refusal(three, options);
        PolygonMesh against{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {0, 1, 2, 0, 1, 3}, {}};
        EXPECT_NE(refusal(against, options).find("wound against each other"), std::string::npos);
        PolygonMesh bow_tie{
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {0, 1, 2, 0, 3, 4}, {}};
        EXPECT_NE(refusal(bow_tie, options).find("vertex 0 at (0, 0, 0) has more than one fan"),
                  std::string::npos)
            << refusal(bow_tie, options);
    }
    EXPECT_NE(refusal(polygon_mesh(shapes::mobius(9)), {}).find("wound against each other"),
              std::string::npos);
}

TEST(Refine, bad_arguments_are_refused) {
    const auto cube = quad_cube();
    EXPECT_NE(refusal(cube, {.scheme = kLoop}).find("face 0 at vertex 3 at (-1, 1, -1) has 4 corners"),
              std::string::npos);
    EXPECT_NE(refusal({}, {}).find("no faces"), std::string::npos);
    EXPECT_NE(refusal({{{0, 0, 0}}, {0, 1, 2}, {}}, {}).find("names vertex 1 of 1"), std::string::npos);
    EXPECT_NE(refusal({{{}, {}, {}}, {0, 1, 1}, {}}, {}).find("twice"), std::string::npos);
    EXPECT_NE(refusal({{{}, {}, {}}, {0, 1, 2}, {2}}, {}).find("2 corners"), std::string::npos);
    EXPECT_NE(refusal({{{}, {}, {}}, {0, 1, 2}, {3, 3}}, {}).find("do not add up"), std::string::npos);
    EXPECT_NE(refusal({{{}, {}, {}}, {0, 1, 2}, {4}}, {}).find("do not add up"), std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.levels = 0}).find("0 levels"), std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.levels = 99}).find("99 levels"), std::string::npos);
    EXPECT_NE(refusal(polygon_mesh(shapes::torus(3, 1, 200, 100)), {.levels = 9}).find("fewer levels"),
              std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.creases = {{4, 5}}})
                  .find("the crease from vertex 4 at (0, 0, 1) to vertex 5"),
              std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.creases = {{4, 6}}}).find("names vertex 6 of 6"), std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.sharp_corners = {{7}}}).find("names vertex 7 of 6"), std::string::npos);
    EXPECT_NE(refusal(octahedron(), {.creases = {{4, 0, std::nan("")}}}).find("sharpness"),
              std::string::npos);
}

}  // namespace
}  // namespace stratareeb
