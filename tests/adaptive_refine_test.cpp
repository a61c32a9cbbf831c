// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/adaptive_refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "tests/refine_cases.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

constexpr auto kLoop = SubdivisionScheme::Loop;
constexpr auto kCatmullClark = SubdivisionScheme::CatmullClark;

double dot(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point3 minus(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point3 along(const Point3& a, const Point3& d, double t) {
    return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
}

// Squared distance of a point from a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double squared_distance(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
    const Point3 ab = minus(b, a), ac = minus(c, a), ap = minus(p, a), bp = minus(p, b), cp = minus(p, c);
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
                 d6 = dot(ac, cp);
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    Point3 q = a;
    if (d1 <= 0 && d2 <= 0) {
        q = a;
    } else if (d3 >= 0 && d4 <= d3) {
        q = b;
    } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        q = along(a, ab, d1 / (d1 - d3));
    } else if (d6 >= 0 && d5 <= d6) {
        q = c;
    } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        q = along(a, ac, d2 / (d2 - d6));
    } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        q = along(b, minus(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    } else {
        q = along(along(a, ab, vb / (va + vb + vc)), ac, vc / (va + vb + vc));
    }
    return dot(minus(p, q), minus(p, q));
}

// The largest distance of points of the limit surface from the triangles, by trying all.
double distance(const PolygonMesh& limit, const PolygonMesh& mesh) {
    const auto soup = triangle_fans(mesh);
    double largest = 0;
    for (std::size_t v = 0; v < limit.points.size(); v += 1 + limit.points.size() / 700) {
        double nearest = 1e300;
        for (const auto& t : soup.triangles)
            nearest = std::min(nearest, squared_distance(limit.points[v], soup.points[t[0]],
                                                         soup.points[t[1]], soup.points[t[2]]));
        largest = std::max(largest, std::sqrt(nearest));
    }
    return largest;
}

PolygonMesh moved_at_random(PolygonMesh mesh, double by) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-by, by);
    for (auto& p : mesh.points) p = {p.x + uniform(random), p.y + uniform(random), p.z + uniform(random)};
    return mesh;
}

struct Case {
    std::string name;
    SubdivisionScheme scheme;
    PolygonMesh mesh;
};

std::vector<Case> closed_cases() {
    return {
        {"octahedron", kLoop, shapes::octahedron()},
        {"cube", kCatmullClark, shapes::quad_cube()},
        {"triangle torus", kLoop, moved_at_random(polygon_mesh(shapes::torus(5, 2, 12, 8)), 0.4)},
        {"quad torus", kCatmullClark, moved_at_random(shapes::quad_torus(5, 2, 12, 8), 0.4)},
        {"prism", kCatmullClark, moved_at_random(shapes::polygon_prism(7, 2, 1), 0.2)},
        {"double torus", kLoop, moved_at_random(polygon_mesh(shapes::double_torus()), 0.1)},
        {"double torus as quads", kCatmullClark, moved_at_random(polygon_mesh(shapes::double_torus()), 0.1)}};
}

TEST(AdaptiveRefine, closed_surfaces_stay_closed_and_are_as_near_as_asked) {
    for (const auto& c : closed_cases())
        for (const double tolerance : {0.2, 0.05, 0.01}) {
            const auto adaptive = adaptive_refine(c.mesh, tolerance, {.scheme = c.scheme, .levels = 6});
            const auto report = analyze(triangle_fans(adaptive.refined.mesh));
            EXPECT_TRUE(report.watertight)
                << c.name << ": " << (report.problems.empty() ? "" : report.problems[0]);
            EXPECT_EQ(report.unused_vertices, 0u);
            EXPECT_EQ(report.genus, analyze(triangle_fans(c.mesh)).genus) << c.name;
            EXPECT_LT(adaptive.levels, 6);
            const auto limit = refine(c.mesh, {.scheme = c.scheme, .levels = adaptive.levels + 1});
            EXPECT_LE(distance(limit.mesh, adaptive.refined.mesh), 1.1 * tolerance) << c.name;
            const auto uniform = refine(c.mesh, {.scheme = c.scheme, .levels = std::max(1, adaptive.levels)});
            EXPECT_LE(adaptive.refined.mesh.face_count(), 2 * uniform.mesh.face_count());
        }
}

TEST(AdaptiveRefine, flat_parts_stay_coarse) {
    // A plate with a small bump: only the bump is cut.
    for (const auto scheme : {kLoop, kCatmullClark}) {
        auto mesh =
            scheme == kLoop ? polygon_mesh(triangle_fans(shapes::quad_grid(20))) : shapes::quad_grid(20);
        mesh.points[10 * 21 + 10].z = 1;
        const auto adaptive = adaptive_refine(mesh, 0.002, {.scheme = scheme, .levels = 6});
        EXPECT_GE(adaptive.levels, 3);
        const auto uniform_faces = mesh.face_count() << (2 * adaptive.levels);
        EXPECT_LT(adaptive.refined.mesh.face_count(), uniform_faces / 10);
        const auto report = analyze(triangle_fans(adaptive.refined.mesh));
        EXPECT_EQ(report.self_intersections, 0u);
        EXPECT_EQ(report.euler, 1);
        EXPECT_EQ(report.boundary_edges, 80u);
        EXPECT_EQ(report.boundary_loops, 1u);
        const auto limit = refine(mesh, {.scheme = scheme, .levels = adaptive.levels + 1});
        EXPECT_LE(distance(limit.mesh, adaptive.refined.mesh), 0.0022);
    }
}

TEST(AdaptiveRefine, a_plane_is_not_cut_at_all) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (const auto scheme : {kLoop, kCatmullClark}) {
        auto mesh =
            scheme == kLoop ? polygon_mesh(triangle_fans(shapes::quad_grid(6))) : shapes::quad_grid(6);
        for (auto& p : mesh.points) {
            const bool inside = p.x > 0 && p.x < 6 && p.y > 0 && p.y < 6;
            if (inside) p = {p.x + uniform(random), p.y + uniform(random), 0};
            p.z = 0.5 * p.x + 0.25 * p.y;
        }
        const auto adaptive = adaptive_refine(mesh, 1e-6, {.scheme = scheme, .levels = 4});
        EXPECT_EQ(adaptive.levels, 0);
        EXPECT_EQ(adaptive.refined.mesh.face_count(), mesh.face_count());
        EXPECT_NEAR(area(triangle_fans(adaptive.refined.mesh)), 36 * std::sqrt(1 + 0.25 + 0.0625), 1e-9);
    }
}

TEST(AdaptiveRefine, outlines_and_creases_are_followed) {
    // A flat disc: its inside needs no cuts, its round outline does.
    const auto disc = polygon_mesh(shapes::disc(8, 1));
    const auto adaptive = adaptive_refine(disc, 1e-3, {.levels = 6, .boundary = BoundaryRule::Smooth});
    const auto limit = refine(disc, {.levels = 6, .boundary = BoundaryRule::Smooth});
    EXPECT_NEAR(area(triangle_fans(adaptive.refined.mesh)), area(triangle_fans(limit.mesh)), 2e-3 * 2 * 3.2);
    EXPECT_GE(analyze(triangle_fans(adaptive.refined.mesh)).boundary_edges, 32u);
    // A cube with sharp edges is flat and straight everywhere.
    const auto cube = adaptive_refine(shapes::quad_cube(), 1e-6,
                                      {.scheme = kCatmullClark, .levels = 4, .crease_angle_deg = 30});
    EXPECT_EQ(cube.refined.mesh.face_count(), 6u);
    EXPECT_NEAR(volume(triangle_fans(cube.refined.mesh)), 8, 1e-12);
}

TEST(AdaptiveRefine, the_deepest_level_is_kept) {
    const auto octahedron = shapes::octahedron();
    for (int levels = 1; levels <= 4; ++levels) {
        const auto adaptive = adaptive_refine(octahedron, 1e-9, {.levels = levels});
        const auto uniform = refine(octahedron, {.levels = levels});
        EXPECT_EQ(adaptive.levels, levels);
        EXPECT_EQ(adaptive.refined.mesh.face_count(), uniform.mesh.face_count());
        EXPECT_NEAR(volume(triangle_fans(adaptive.refined.mesh)), volume(triangle_fans(uniform.mesh)), 1e-14);
        EXPECT_EQ(adaptive.refined.mesh.points, uniform.mesh.points);
        EXPECT_EQ(adaptive.refined.normals, uniform.normals);
    }
}

TEST(AdaptiveRefine, random_meshes_have_no_cracks) {
    std::mt19937 random(17);
    for (int round = 0; round < 60; ++round) {
        auto mesh = polygon_mesh(shapes::terrain(3 + round % 5));
        for (auto& p : mesh.points) p.z = std::uniform_real_distribution<double>(-1, 1)(random);
        const auto scheme = round % 2 == 0 ? kLoop : kCatmullClark;
        const double tolerance = std::pow(10.0, -std::uniform_real_distribution<double>(0.5, 3)(random));
        const auto adaptive = adaptive_refine(mesh, tolerance, {.scheme = scheme, .levels = 4});
        const auto report = analyze(triangle_fans(adaptive.refined.mesh), {.self_intersections = false});
        EXPECT_TRUE(report.manifold && report.oriented);
        EXPECT_EQ(report.euler, 1);
        EXPECT_EQ(report.boundary_loops, 1u);
        EXPECT_EQ(report.degenerate_triangles, 0u);
        // A crack would let the plan be covered twice or not at all.
        double plan = 0;
        for (const auto& t : triangle_fans(adaptive.refined.mesh).triangles) {
            const auto &a = adaptive.refined.mesh.points[t[0]], &b = adaptive.refined.mesh.points[t[1]],
                       &c = adaptive.refined.mesh.points[t[2]];
            const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            EXPECT_GT(twice, 0);
            plan += twice / 2;
        }
        double whole = 0;
        for (const auto& t : triangle_fans(mesh).triangles) {
            const auto &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
            whole += ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
        }
        EXPECT_LE(plan, whole * (1 + 1e-12));
    }
}

TEST(AdaptiveRefine, bad_tolerances_are_refused) {
    for (const double tolerance : {0.0, -1.0, std::nan("")})
        EXPECT_THROW(adaptive_refine(shapes::octahedron(), tolerance), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
