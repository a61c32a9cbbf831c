// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/level_set.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <utility>

#include "bench/reeb_meshes.h"
#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using std::numbers::pi;

double total_length(const LevelSet& set) {
    double sum = 0;
    for (const auto& contour : set.contours) sum += contour.length();
    return sum;
}

double total_area(const LevelSet& set) {
    double sum = 0;
    for (const auto& contour : set.contours) sum += contour.plan_area();
    return sum;
}

//! Error of a level's length and of its area for a mesh refined again and again: each halving of the triangles divides it by
//! about four (more or less, as the level meets the rows of vertices elsewhere).
template <class Mesh>
void expect_second_order(Mesh mesh_of, double level, double length, double area) {
    std::vector<double> length_error, area_error;
    for (const shapes::Index n : {32u, 64u, 128u, 256u}) {
        const TriMesh mesh = half_edge_mesh(mesh_of(n));
        const auto set = level_sets(mesh, height_field(mesh), std::array{level})[0];
        length_error.push_back(std::abs(total_length(set) - length));
        area_error.push_back(std::abs(total_area(set) - area));
    }
    EXPECT_GT(std::log2(length_error.front() / length_error.back()) / 3, 1.7);
    EXPECT_GT(std::log2(area_error.front() / area_error.back()) / 3, 1.7);
    EXPECT_LT(length_error.back(), 1e-3 * length);
    EXPECT_LT(area_error.back(), 1e-3 * area);
}

TEST(LevelSet, circles_of_a_sphere_converge_to_second_order) {
    const double r = std::sqrt(4 - 0.49);
    expect_second_order([](shapes::Index n) { return shapes::uv_sphere(2, n, 2 * n); }, 0.7, 2 * pi * r,
                        pi * r * r);
}

TEST(LevelSet, circles_of_a_lying_torus_converge_to_second_order) {
    const double half = std::sqrt(1 - 0.16);
    expect_second_order([](shapes::Index n) { return shapes::torus(3, 1, 2 * n, n); }, 0.4, 2 * pi * 6,
                        pi * ((3 + half) * (3 + half) - (3 - half) * (3 - half)));
}

TEST(LevelSet, circles_of_a_standing_torus_converge_to_second_order) {
    const auto standing = [](shapes::Index n) {  // cut through its axis: two circles of the tube
        auto soup = shapes::torus(3, 1, 2 * n + 1, n);
        for (auto& p : soup.points) p = {p.y, p.z, p.x};
        return soup;
    };
    expect_second_order(standing, 0, 4 * pi, 2 * pi);
}

//! Apex at height 2 over a base of radius 1, `rings` of triangles.
TriangleSoup cone(shapes::Index sides, shapes::Index rings) {
    TriangleSoup soup;
    for (shapes::Index k = 0; k < rings; ++k)
        for (shapes::Index i = 0; i < sides; ++i) {
            const double u = 2 * pi * (i + 0.5 * k) / sides, r = 1 - double(k) / rings;
            soup.points.push_back({r * std::cos(u), r * std::sin(u), 2 * (1 - r)});
        }
    soup.points.push_back({0, 0, 2});
    soup.points.push_back({0, 0, 0});
    const auto apex = static_cast<shapes::Index>(soup.points.size() - 2);
    for (shapes::Index i = 0; i < sides; ++i) {
        const shapes::Index j = (i + 1) % sides, last = (rings - 1) * sides;
        soup.triangles.push_back({apex + 1, j, i});
        soup.triangles.push_back({last + i, last + j, apex});
        for (shapes::Index k = 0; k + 1 < rings; ++k) {
            const shapes::Index a = k * sides, b = a + sides;
            soup.triangles.push_back({a + i, a + j, b + i});
            soup.triangles.push_back({a + j, b + j, b + i});
        }
    }
    return soup;
}

TEST(LevelSet, circles_of_a_cone_converge_to_second_order) {
    expect_second_order([](shapes::Index n) { return cone(2 * n, n); }, 0.7, 2 * pi * 0.65, pi * 0.65 * 0.65);
    // At a ring of vertices the contour is that ring, a regular polygon.
    const TriMesh mesh = half_edge_mesh(cone(12, 4));
    const auto ring = level_sets(mesh, height_field(mesh), std::array{0.5})[0];
    EXPECT_EQ(ring.contours.at(0).points.size(), 12u);
    EXPECT_NEAR(total_length(ring), 24 * 0.75 * std::sin(pi / 12), 1e-14);
    EXPECT_NEAR(total_area(ring), 6 * 0.75 * 0.75 * std::sin(pi / 6), 1e-14);
}

TEST(LevelSet, circles_around_a_place_converge_to_second_order) {
    std::vector<double> error;
    for (const shapes::Index n : {16u, 32u, 64u, 128u}) {
        const TriMesh plane = half_edge_mesh(shapes::terrain(n, [](double, double) { return 0; }));
        const double radius = 0.3 * n;
        const auto set =
            level_sets(plane, distance_field(plane, {n / 2.0, n / 2.0, 0}), std::array{radius})[0];
        ASSERT_EQ(set.contours.size(), 1u);
        error.push_back(std::abs(total_length(set) / radius - 2 * pi));
        EXPECT_LT(set.contours[0].plan_area(), 0) << "lower inside: clockwise seen from above";
    }
    EXPECT_GT(std::log2(error.front() / error.back()) / 3, 1.7);
    EXPECT_LT(error.back(), 1e-3);
}

TEST(LevelSet, total_length_over_many_levels_of_a_sphere) {
    const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(1, 120, 240));
    const auto field = height_field(sphere);
    const auto sets = level_sets(sphere, field, even_levels(field, 999));
    double sum = 0;
    for (const auto& set : sets) sum += total_length(set);
    EXPECT_NEAR(sum * 2 / 1000, pi * pi, 2e-3 * pi * pi);  // the integral of 2 pi sqrt(1 - z^2) over z
}

TEST(LevelSet, a_lying_torus_has_two_circles_at_each_level) {
    const TriMesh torus = half_edge_mesh(shapes::torus(3, 1, 400, 200));
    const auto set = level_sets(torus, height_field(torus), std::array{0.4})[0];
    ASSERT_EQ(set.contours.size(), 2u);
    const double half = std::sqrt(1 - 0.16);
    EXPECT_NEAR(total_length(set), 2 * pi * 6, 1e-2);
    EXPECT_NEAR(total_area(set), pi * ((3 + half) * (3 + half) - (3 - half) * (3 - half)), 2e-2);
    EXPECT_LT(set.contours[0].plan_area() * set.contours[1].plan_area(), 0)
        << "the inner one runs the other way";
}

TEST(LevelSet, areas_integrate_to_the_volume) {
    std::mt19937_64 random(5);
    for (const auto& shape : shapes::solids()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        const auto field = height_field(mesh);
        const auto [low, high] = std::ranges::minmax(field);
        if (!(high > low)) continue;
        constexpr std::size_t kLevels = 2000;
        std::vector<double> levels;  // midpoint rule
        for (std::size_t k = 0; k < kLevels; ++k)
            levels.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / kLevels);
        double sum = 0;
        for (const auto& set : level_sets(mesh, field, levels)) sum += total_area(set);
        EXPECT_NEAR(sum * (high - low) / kLevels, volume(mesh), 2e-3 * volume(mesh)) << shape.name;
    }
}

TEST(LevelSet, takes_every_crossed_edge_once_without_gaps) {
    std::mt19937_64 random(6);
    auto shapes = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) shapes.push_back(std::move(shape));
    for (const auto& shape : shapes) {
        const MeshReport report = analyze(shape.soup);
        if (!report.manifold || !report.oriented) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 5; ++round) {
            ScalarField field(mesh.n_vertices());
            for (double& value : field) value = static_cast<double>(random() % 1000000) + 0.5;
            const double level = static_cast<double>(random() % 1000000);
            std::size_t crossed = 0, boundary = 0;
            for (const auto e : mesh.edges()) {
                const auto h = mesh.halfedge_handle(e, 0);
                const bool a = field[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())] >= level;
                const bool b = field[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())] >= level;
                crossed += a != b;
                boundary += a != b && mesh.is_boundary(e);
            }
            std::size_t points = 0, open = 0;
            const auto sets = level_sets(mesh, field, std::array{level});
            for (const auto& contour : sets[0].contours) {
                points += contour.points.size();
                open += !contour.closed;
                for (std::size_t i = 0; i + 1 < contour.points.size(); ++i)
                    EXPECT_FALSE(contour.points[i] == contour.points[i + 1]);
            }
            EXPECT_EQ(points, crossed) << shape.name;
            EXPECT_EQ(2 * open, boundary) << shape.name;
        }
    }
}

using Segment = std::array<double, 6>;

Segment segment_of(const Point3& a, const Point3& b) {
    return {a.x, a.y, a.z, b.x, b.y, b.z};
}

//! The level set from its definition, a triangle at a time: the segment on which the linear field has that value, turned so
//! that the gradient points to its left. Segments without length are left out.
std::multiset<Segment> segments_by_triangle(const TriMesh& mesh, const ScalarField& field, double level) {
    std::multiset<Segment> segments;
    for (const auto f : mesh.faces()) {
        std::vector<OpenMesh::Vec3d> points;
        OpenMesh::Vec3d inside(0, 0, 0), outside(0, 0, 0);  // sums of the corners above and below
        double above = 0, below = 0;
        for (const auto h : mesh.fh_range(f)) {
            auto a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
            const auto value = [&](TriMesh::VertexHandle v) {
                return field[static_cast<std::size_t>(v.idx())];
            };
            (value(a) >= level ? above : below) += 1;
            (value(a) >= level ? inside : outside) += mesh.point(a);
            if ((value(a) >= level) == (value(b) >= level)) continue;
            if (value(a) < level) std::swap(a, b);
            points.push_back(mesh.point(a) +
                             (value(a) - level) / (value(a) - value(b)) * (mesh.point(b) - mesh.point(a)));
        }
        if (points.size() != 2 || points[0] == points[1]) continue;
        const auto normal = mesh.calc_face_normal(f);
        const auto left = OpenMesh::cross(normal, points[1] - points[0]);
        if (OpenMesh::dot(left, inside / above - outside / below) < 0) std::swap(points[0], points[1]);
        segments.insert({points[0][0], points[0][1], points[0][2], points[1][0], points[1][1], points[1][2]});
    }
    return segments;
}

std::multiset<Segment> segments_of(const LevelSet& set) {
    std::multiset<Segment> segments;
    for (const auto& [points, closed] : set.contours) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            segments.insert(segment_of(points[i], points[i + 1]));
        if (closed) segments.insert(segment_of(points.back(), points.front()));
    }
    return segments;
}

TEST(LevelSet, is_each_triangles_segment_once_with_higher_values_on_its_left) {
    std::mt19937_64 random(8);
    auto shapes = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) shapes.push_back(std::move(shape));
    for (const auto& shape : shapes) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 30; ++round) {
            const std::uint64_t values =
                round % 2 ? 4 : 1000000;  // few: levels at vertices, ridges and plateaus
            ScalarField field(mesh.n_vertices());
            for (double& value : field) value = static_cast<double>(random() % values);
            const auto level = static_cast<double>(1 + random() % (values - 1));
            const auto set = level_sets(mesh, field, std::array{level})[0];
            EXPECT_EQ(segments_of(set), segments_by_triangle(mesh, field, level)) << shape.name;
        }
    }
}

TEST(LevelSet, open_contours_run_from_boundary_to_boundary) {
    const TriMesh mesh = half_edge_mesh(bench::fractal_terrain(40));
    const auto field = height_field(mesh);
    std::size_t open = 0;
    const auto on_rim = [](const Point3& p) { return p.x == 0 || p.y == 0 || p.x == 39 || p.y == 39; };
    for (const auto& set : level_sets(mesh, field, even_levels(field, 50)))
        for (const auto& contour : set.contours) {
            if (contour.closed) continue;
            ++open;
            EXPECT_TRUE(on_rim(contour.points.front()) && on_rim(contour.points.back()));
        }
    EXPECT_GT(open, 50u);
}

//! Twice the area of a triangle in plan.
double turn(const Point3& a, const Point3& b, const Point3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(LevelSet, contours_do_not_cross) {
    std::mt19937_64 random(9);
    for (int round = 0; round < 200; ++round) {
        const bool few = round % 2;
        const TriMesh mesh = half_edge_mesh(shapes::terrain(
            7, [&](double, double) { return static_cast<double>(random() % (few ? 4 : 1000)); }));
        const auto set = level_sets(mesh, height_field(mesh), std::array{few ? 2.0 : 500.5})[0];
        std::vector<std::pair<Point3, Point3>> segments;
        for (const auto& [points, closed] : set.contours)
            for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
                segments.emplace_back(points[i], points[(i + 1) % points.size()]);
        const auto apart = [](double u, double v) { return u * v > -1e-24; };
        for (const auto& [a, b] : segments)
            for (const auto& [c, d] : segments)
                EXPECT_TRUE(apart(turn(a, b, c), turn(a, b, d)) || apart(turn(c, d, a), turn(c, d, b)));
    }
}

TEST(LevelSet, many_levels_at_once_are_those_found_one_by_one) {
    const TriMesh mesh = half_edge_mesh(bench::scan_like_blob(12, 1));
    auto field = height_field(mesh);
    field[3] = 1e300;  // far from all others
    field[4] = -1e300;
    const double tiny = std::numeric_limits<double>::denorm_min();
    std::vector<double> levels{-1e300,   1e300,   0, tiny, -tiny, 2 * tiny, 0.5, std::nextafter(0.5, 1),
                               field[7], field[8]};
    std::mt19937_64 random(10);
    for (int k = 0; k < 50; ++k)
        levels.push_back(0.2 + 1e-12 * static_cast<double>(random() % 1000));  // crowded
    for (const double spread : {0.0, std::numeric_limits<double>::max()}) {
        if (spread > 0) levels.insert(levels.end(), {spread, -spread});  // a range that overflows
        const auto sets = level_sets(mesh, field, levels);
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const auto alone = level_sets(mesh, field, std::array{levels[k]})[0];
            EXPECT_EQ(sets[k].level, levels[k]);
            ASSERT_EQ(sets[k].contours.size(), alone.contours.size());
            for (std::size_t c = 0; c < alone.contours.size(); ++c)
                EXPECT_EQ(sets[k].contours[c].points, alone.contours[c].points);
        }
    }
}

TEST(LevelSet, does_not_depend_on_the_number_of_threads) {
    const TriMesh mesh = half_edge_mesh(bench::scan_like_blob(60, bench::kScanNoise));
    const auto field = height_field(mesh);
    const auto levels = even_levels(field, 60);
    const auto with_threads = [&](std::size_t count) {
        const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, count);
        return level_sets(mesh, field, levels);
    };
    const auto one = with_threads(1), many = with_threads(4);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        ASSERT_EQ(one[k].contours.size(), many[k].contours.size());
        for (std::size_t c = 0; c < one[k].contours.size(); ++c)
            EXPECT_EQ(one[k].contours[c].points, many[k].contours[c].points);
    }
}

TEST(LevelSet, passes_over_deleted_triangles) {
    TriMesh mesh = half_edge_mesh(shapes::terrain(6, [](double x, double) { return x; }));
    const auto before = level_sets(mesh, height_field(mesh), std::array{2.5})[0];
    ASSERT_EQ(before.contours.size(), 1u);
    for (int f = 2 * (3 * 6 + 2); f < 2 * (3 * 6 + 3); ++f)  // the cell at 2, 3
        mesh.delete_face(TriMesh::FaceHandle(f), false);
    const auto after = level_sets(mesh, height_field(mesh), std::array{2.5})[0];
    ASSERT_EQ(after.contours.size(), 2u);
    EXPECT_NEAR(total_length(before) - total_length(after), 1, 1e-15);
}

TEST(LevelSet, area_is_seen_along_a_direction) {
    const Contour square{.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}};
    EXPECT_DOUBLE_EQ(square.plan_area(), 1);
    EXPECT_DOUBLE_EQ(square.area({0, 0, -7}), -1);
    EXPECT_DOUBLE_EQ(square.area({0, -3, 0}), 1);
    EXPECT_DOUBLE_EQ(square.area({0, -1, 1}), std::sqrt(2));
    EXPECT_EQ(square.area({1, 0, 0}), 0);
    EXPECT_EQ(square.area({0, 0, 0}), 0);
    EXPECT_EQ((Contour{.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, .closed = false}.plan_area()), 0);
}

TEST(LevelSet, is_exact_at_the_height_of_vertices_and_plateaus) {
    // A pyramid with a flat top: the level of the plateau runs along its rim.
    const TriMesh box = half_edge_mesh(shapes::slab(2, 3, 1));
    const auto top = level_sets(box, height_field(box), std::array{1.0, 0.5, 0.0, 1.5})[0];
    ASSERT_EQ(top.contours.size(), 1u);
    EXPECT_EQ(top.contours[0].points.size(), 4u);
    EXPECT_DOUBLE_EQ(top.contours[0].length(), 10);
    EXPECT_DOUBLE_EQ(top.contours[0].plan_area(), 6);
    const auto all = level_sets(box, height_field(box), std::array{0.5, 0.0, 1.5});
    EXPECT_DOUBLE_EQ(total_area(all[0]), 6);
    EXPECT_TRUE(all[1].contours.empty()) << "everything is above or at its lowest level";
    EXPECT_TRUE(all[2].contours.empty());
    const TriMesh sphere = half_edge_mesh(shapes::uv_sphere(1, 10, 20));  // a ring of vertices at the equator
    const auto equator = level_sets(sphere, height_field(sphere),
                                    std::array{sphere.point(TriMesh::VertexHandle(1 + 4 * 20))[2]})[0];
    ASSERT_EQ(equator.contours.size(), 1u);
    EXPECT_EQ(equator.contours[0].points.size(), 20u);
}

TEST(LevelSet, returns_levels_in_the_order_asked_for_and_refuses_what_is_no_number) {
    const TriMesh cube = half_edge_mesh(shapes::cube());
    const auto field = height_field(cube);
    const auto sets = level_sets(cube, field, std::array{0.9, 0.1, 0.9});
    ASSERT_EQ(sets.size(), 3u);
    EXPECT_EQ(sets[0].level, 0.9);
    EXPECT_EQ(sets[1].level, 0.1);
    EXPECT_EQ(sets[2].contours.size(), 1u);
    EXPECT_THROW(level_sets(cube, field, std::array{std::nan("")}), InvalidInput);
    EXPECT_THROW(level_sets(cube, ScalarField(2), std::array{0.5}), InvalidInput);
    EXPECT_TRUE(level_sets(TriMesh(), {}, std::array{0.5})[0].contours.empty());
    EXPECT_EQ(even_levels({0, 10}, 4), (std::vector<double>{2, 4, 6, 8}));
    EXPECT_THROW(height_field(cube, {0, 0, 0}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
