// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/plan_cases.h"

namespace stratareeb {
namespace {

using testing::PlanCase;

Point2 place(const TriMesh& mesh, OpenMesh::VertexHandle v) {
    return {mesh.point(v)[0], mesh.point(v)[1]};
}

std::array<Point2, 3> corners(const TriMesh& mesh, OpenMesh::FaceHandle f) {
    std::array<Point2, 3> result;
    auto corner = mesh.cfv_ccwbegin(f);
    for (Point2& p : result) p = place(mesh, *corner++);
    return result;
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double plan_area(const TriMesh& mesh) {
    double sum = 0;
    for (const auto f : mesh.faces()) {
        const auto [a, b, c] = corners(mesh, f);
        sum += turn(a, b, c) / 2;
    }
    return sum;
}

double longest_edge(const TriMesh& mesh) {
    double longest = 0;
    for (const auto e : mesh.edges()) longest = std::max(longest, mesh.calc_edge_length(e));
    return longest;
}

double smallest_angle_deg(const TriMesh& mesh) {
    double smallest = 180;
    for (const auto h : mesh.halfedges())
        if (!mesh.is_boundary(h))
            smallest = std::min(smallest, mesh.calc_sector_angle(h) * 180 / std::numbers::pi);
    return smallest;
}

double distance(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

//! Edges of the mesh lie all the way along a segment.
bool is_covered(const TriMesh& mesh, const Point2& a, const Point2& b, double tolerance) {
    double covered = 0;
    for (const auto e : mesh.edges()) {
        const auto h = mesh.halfedge_handle(e, 0);
        const Point2 p = place(mesh, mesh.from_vertex_handle(h)), q = place(mesh, mesh.to_vertex_handle(h));
        if (distance(p, a, b) <= tolerance && distance(q, a, b) <= tolerance)
            covered += mesh.calc_edge_length(e);
    }
    return std::abs(covered - std::hypot(b.x - a.x, b.y - a.y)) <= 1e-6;
}

//! > 0 if d lies in the circle through a, b, c (counter-clockwise), in terms of the circle's size.
double in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const long double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x,
                      cy = c.y - d.y;
    const long double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const long double size = std::max({a2, b2, c2});
    return static_cast<double>(
        (a2 * (bx * cy - by * cx) - b2 * (ax * cy - ay * cx) + c2 * (ax * by - ay * bx)) / (size * size));
}

using Segments = std::vector<std::pair<Point2, Point2>>;

Segments sides_of(const Footprint& footprint, const PlanLines& lines) {
    Segments segments;
    for (const auto& ring : footprint)
        for (std::size_t i = 0; i < ring.size(); ++i)
            segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    for (const auto& [a, b] : lines.segments) segments.emplace_back(lines.points[a], lines.points[b]);
    return segments;
}

//! Each edge that no line asked for is Delaunay.
void expect_delaunay(const TriMesh& mesh, const Segments& given) {
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e)) continue;
        const auto h = mesh.halfedge_handle(e, 0), o = mesh.opposite_halfedge_handle(h);
        const Point2 a = place(mesh, mesh.from_vertex_handle(h)), b = place(mesh, mesh.to_vertex_handle(h));
        const Point2 c = place(mesh, mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
        const Point2 d = place(mesh, mesh.to_vertex_handle(mesh.next_halfedge_handle(o)));
        const bool asked_for = std::ranges::any_of(given, [&](const auto& s) {
            return distance(a, s.first, s.second) < 1e-7 && distance(b, s.first, s.second) < 1e-7;
        });
        if (!asked_for) {
            EXPECT_LE(in_circle(a, b, c, d), 1e-9) << a.x << " " << a.y << " to " << b.x << " " << b.y;
        }
    }
}

void expect_unfolded(const TriMesh& mesh) {
    for (const auto f : mesh.faces()) {
        const auto [a, b, c] = corners(mesh, f);
        EXPECT_GT(turn(a, b, c), 0);
    }
    for (const auto v : mesh.vertices()) EXPECT_FALSE(mesh.is_isolated(v));
}

void expect_holes_are_vertices(const PlanMesh& plan, const std::vector<Point2>& holes) {
    ASSERT_EQ(plan.hole_vertex.size(), holes.size());
    for (std::size_t h = 0; h < holes.size(); ++h) {
        ASSERT_NE(plan.hole_vertex[h], PlanMesh::kNoVertex) << "hole " << h;
        const auto v = OpenMesh::VertexHandle(static_cast<int>(plan.hole_vertex[h]));
        EXPECT_EQ(place(plan.surface, v), holes[h]) << "to the last bit";
    }
}

const Footprint kSquare{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
const Footprint kWindow{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{40, 40}, {40, 60}, {60, 60}, {60, 40}}};

TEST(PlanMesh, of_a_plain_square_has_good_short_triangles) {
    for (const double spacing : {50.0, 17.0, 4.0}) {
        const PlanMesh plan = build_plan_mesh(kSquare, {}, {}, {.spacing = spacing});
        expect_unfolded(plan.surface);
        EXPECT_NEAR(plan_area(plan.surface), 1e4, 1e-8);
        EXPECT_LE(longest_edge(plan.surface), spacing * (1 + 1e-12));
        EXPECT_GE(smallest_angle_deg(plan.surface), 20 - 1e-9);
        expect_delaunay(plan.surface, sides_of(kSquare, {}));
    }
}

TEST(PlanMesh, of_a_polygon_with_a_hole_leaves_the_hole_free) {
    const PlanMesh plan = build_plan_mesh(kWindow, {{10, 10}, {50, 20}, {50, 50}}, {}, {.spacing = 9});
    expect_unfolded(plan.surface);
    EXPECT_NEAR(plan_area(plan.surface), 1e4 - 400, 1e-8);
    EXPECT_LE(longest_edge(plan.surface), 9 * (1 + 1e-12));
    EXPECT_GE(smallest_angle_deg(plan.surface), 20 - 1e-9);
    EXPECT_EQ(plan.hole_vertex[2], PlanMesh::kNoVertex) << "this borehole stands in the window";
    const auto& mesh = plan.surface;
    const auto euler = static_cast<long long>(mesh.n_vertices()) - static_cast<long long>(mesh.n_edges()) +
                       static_cast<long long>(mesh.n_faces());
    EXPECT_EQ(euler, 0) << "a ring";
    for (const auto f : mesh.faces()) {
        const auto [a, b, c] = corners(mesh, f);
        EXPECT_TRUE(is_inside(kWindow, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}));
    }
}

TEST(PlanMesh, keeps_islands_and_several_parts) {
    Footprint parts = kWindow;
    parts.push_back({{45, 45}, {55, 45}, {55, 55}, {45, 55}});
    parts.push_back({{200, 0}, {210, 0}, {210, 10}, {200, 10}});
    const PlanMesh plan = build_plan_mesh(parts, {{50, 50}, {205, 5}}, {}, {.spacing = 7});
    EXPECT_NEAR(plan_area(plan.surface), 1e4 - 400 + 100 + 100, 1e-8);
    expect_holes_are_vertices(plan, {{50, 50}, {205, 5}});
}

TEST(PlanMesh, without_spacing_is_the_bare_triangulation) {
    const std::vector<Point2> holes{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {30, 40}, {70, 20}};
    const PlanMesh plan = build_plan_mesh(kSquare, holes, {});
    EXPECT_EQ(plan.surface.n_vertices(), holes.size());
    EXPECT_EQ(plan.surface.n_faces(), HoleTriangulation(holes).triangles().size());
    expect_holes_are_vertices(plan, holes);
    expect_delaunay(plan.surface, sides_of(kSquare, {}));
}

TEST(PlanMesh, follows_random_layers_and_honours_holes) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const PlanCase c = testing::random_plan_case(seed);
        const auto field = thickness_field(c);
        const PlanLines lines = testing::plan_lines(field, c.spacing);
        const Footprint footprint = hull_footprint(field.holes());
        const PlanMesh plan = build_plan_mesh(footprint, c.sites, lines, {.spacing = c.spacing});
        expect_unfolded(plan.surface);
        expect_holes_are_vertices(plan, c.sites);
        EXPECT_NEAR(plan_area(plan.surface), area(footprint), 1e-12 * area(footprint));
        if (c.spacing > 0) {
            EXPECT_LE(longest_edge(plan.surface), c.spacing * (1 + 1e-12));
        }
        for (const auto& [a, b] : lines.segments)
            EXPECT_TRUE(is_covered(plan.surface, lines.points[a], lines.points[b], 1e-9));
        expect_delaunay(plan.surface, sides_of(footprint, lines));
    }
}

TEST(PlanMesh, keeps_its_area_far_from_the_origin) {
    const Point2 corner{5e6, 4.9e6};
    Footprint footprint = kWindow;
    for (auto& ring : footprint)
        for (Point2& p : ring) p = {p.x + corner.x, p.y + corner.y};
    const PlanMesh plan =
        build_plan_mesh(footprint, {{corner.x + 20.5, corner.y + 30.25}}, {}, {.spacing = 10});
    expect_unfolded(plan.surface);
    EXPECT_NEAR(plan_area(plan.surface), 9600, 1e-12 * 9600 + 1e-6);
    expect_holes_are_vertices(plan, {{corner.x + 20.5, corner.y + 30.25}});
}

TEST(PlanMesh, is_the_same_each_time) {
    const PlanCase c = testing::random_plan_case(12);
    const auto build = [&] {
        const auto field = thickness_field(c);
        return testing::plan_mesh(field, 6);
    };
    const PlanMesh one = build(), two = build();
    ASSERT_EQ(one.surface.n_vertices(), two.surface.n_vertices());
    ASSERT_EQ(one.surface.n_faces(), two.surface.n_faces());
    for (const auto v : one.surface.vertices()) ASSERT_EQ(one.surface.point(v), two.surface.point(v));
    for (const auto f : one.surface.faces()) ASSERT_EQ(corners(one.surface, f), corners(two.surface, f));
    EXPECT_EQ(one.hole_vertex, two.hole_vertex);
}

TEST(PlanMesh, gives_holes_outside_no_vertex_and_holes_on_the_outline_theirs) {
    const PlanMesh plan = build_plan_mesh(kSquare, {{150, 50}, {100, 37}, {50, 1e-8}}, {}, {.spacing = 20});
    EXPECT_EQ(plan.hole_vertex[0], PlanMesh::kNoVertex);
    EXPECT_NE(plan.hole_vertex[1], PlanMesh::kNoVertex);
    EXPECT_NE(plan.hole_vertex[2], PlanMesh::kNoVertex);
    expect_unfolded(plan.surface);
    EXPECT_NEAR(plan_area(plan.surface), 1e4, 1e-5);
}

TEST(PlanMesh, clips_lines_at_the_outline) {
    const PlanLines line{{{-50, 33}, {150, 71}}, {{0, 1}}};
    const PlanMesh plan = build_plan_mesh(kSquare, {}, line, {.spacing = 15});
    EXPECT_NEAR(plan_area(plan.surface), 1e4, 1e-8);
    EXPECT_TRUE(is_covered(plan.surface, {0, 42.5}, {100, 61.5}, 1e-9));
}

TEST(PlanMesh, reports_progress_of_big_meshes) {
    std::size_t calls = 0, last = 0;
    PlanMeshOptions options{.spacing = 2};
    options.progress = [&](std::size_t vertices) {
        EXPECT_GE(vertices, last);
        last = vertices;
        ++calls;
    };
    build_plan_mesh(kSquare, {}, {}, options);
    EXPECT_GT(calls, 0u);
}

TEST(SuitableSpacing, gives_the_wanted_number_of_equilateral_triangles) {
    const auto triangles = [](double spacing) { return 1e4 / (std::sqrt(3.0) / 4 * spacing * spacing); };
    EXPECT_NEAR(triangles(suitable_spacing(kSquare, 3)), 2500, 1e-6);
    EXPECT_NEAR(triangles(suitable_spacing(kSquare, 10'000)), 90'000, 1e-4);
}

}  // namespace
}  // namespace stratareeb
