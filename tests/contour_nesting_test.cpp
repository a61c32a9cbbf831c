// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_nesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

#include "bench/reeb_meshes.h"
#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = ContourNesting::kNone;

LevelSet level_of(const TriangleSoup& soup, double level, const Point3& direction = {0, 0, 1}) {
    const TriMesh mesh = half_edge_mesh(soup);
    return level_sets(mesh, height_field(mesh, direction), std::array{level})[0];
}

//! In plan: does the ring wind around the point? By the sum of angles, which needs no cases.
bool winds_around(const Contour& ring, const Point3& p) {
    double turn = 0;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Point3 &a = ring.points[i], &b = ring.points[(i + 1) % ring.points.size()];
        const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
        turn += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return std::abs(turn) > std::numbers::pi;
}

//! Parents by all pairs, for contours that do not touch.
std::vector<std::uint32_t> parents_by_all_pairs(const LevelSet& set) {
    const auto count = static_cast<std::uint32_t>(set.contours.size());
    std::vector<std::vector<std::uint32_t>> around(count);
    for (std::uint32_t c = 0; c < count; ++c)
        for (std::uint32_t d = 0; d < count; ++d)
            if (c != d && set.contours[c].closed && set.contours[d].closed &&
                winds_around(set.contours[d], set.contours[c].points[0]))
                around[c].push_back(d);
    std::vector<std::uint32_t> parent(count, kNone);
    for (std::uint32_t c = 0; c < count; ++c)
        for (const auto d : around[c])
            if (around[d].size() + 1 == around[c].size()) parent[c] = d;
    return parent;
}

//! What holds for the forest of any set of contours.
void expect_sound(const LevelSet& set, const ContourNesting& nesting) {
    ASSERT_EQ(nesting.parent.size(), set.contours.size());
    ASSERT_EQ(nesting.depth.size(), set.contours.size());
    std::vector<int> listed(set.contours.size(), 0);
    for (const auto c : nesting.open) {
        ++listed[c];
        EXPECT_FALSE(set.contours[c].closed);
        EXPECT_EQ(nesting.parent[c], kNone);
    }
    for (const auto& [outer, holes] : nesting.polygons) {
        ++listed[outer];
        EXPECT_EQ(nesting.depth[outer] % 2, 0u);
        for (const auto hole : holes) {
            ++listed[hole];
            EXPECT_EQ(nesting.parent[hole], outer);
        }
    }
    EXPECT_EQ(std::ranges::count(listed, 1), std::ssize(listed)) << "each contour has one place";
    for (std::uint32_t c = 0; c < set.contours.size(); ++c) {
        const auto parent = nesting.parent[c];
        EXPECT_EQ(nesting.depth[c], parent == kNone ? 0 : nesting.depth[parent] + 1);
    }
}

//! Walls and ditches around the middle of the terrain, in whole numbers.
void add_waves(std::vector<double>& height, shapes::Index n, double amplitude) {
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) {
            const double r = std::hypot(double(i) - n / 2.0, double(j) - n / 2.0);
            height[j * (n + 1) + i] += std::round(amplitude * std::cos(1.6 * r));
        }
}

double signed_area(const LevelSet& set, const Point3& direction = {0, 0, 1}) {
    double sum = 0;
    for (const auto& contour : set.contours) sum += contour.area(direction);
    return sum;
}

TEST(ContourNesting, agrees_with_all_pairs_on_random_terrains) {
    std::mt19937_64 random(11);
    std::size_t contours = 0, deepest = 0;
    for (int round = 0; round < 500; ++round) {
        const auto n = static_cast<shapes::Index>(3 + random() % 22);
        std::vector<double> height(std::size_t(n + 1) * (n + 1));
        for (double& h : height) h = static_cast<double>(random() % 1000) + 0.5;
        if (round % 2) add_waves(height, n, 1000);
        const auto set = level_of(
            shapes::terrain(
                n, [&](double x, double y) { return height[std::size_t(y) * (n + 1) + std::size_t(x)]; }),
            static_cast<double>(random() % 1000));
        const auto nesting = nest_contours(set);
        expect_sound(set, nesting);
        ASSERT_EQ(nesting.parent, parents_by_all_pairs(set)) << "round " << round;
        contours += set.contours.size();
        for (const auto depth : nesting.depth) deepest = std::max<std::size_t>(deepest, depth);
    }
    EXPECT_GT(contours, 5000u);
    EXPECT_GE(deepest, 4u);
}

TEST(ContourNesting, agrees_with_all_pairs_on_thousands_of_contours_at_once) {
    const TriMesh mesh = half_edge_mesh(bench::fractal_terrain(240));
    auto field = height_field(mesh);
    auto sorted = field;
    std::ranges::sort(sorted);
    const auto set = level_sets(mesh, field, std::array{sorted[sorted.size() / 2]})[0];
    const auto nesting = nest_contours(set);
    expect_sound(set, nesting);
    EXPECT_EQ(nesting.parent, parents_by_all_pairs(set));
    std::mt19937_64 random(12);
    ScalarField noise(mesh.n_vertices());
    for (double& value : noise) value = static_cast<double>(random() % 1000) + 0.5;
    const auto many = level_sets(mesh, noise, std::array{500.0})[0];
    EXPECT_GT(many.contours.size(), 2000u);
    EXPECT_EQ(nest_contours(many).parent, parents_by_all_pairs(many));
}

//! Just below a level the same edges are crossed as at the level, so the contours are the same but for those around summits
//! of that height.
LevelSet without_points(LevelSet set) {
    std::erase_if(set.contours, [](const Contour& contour) {
        return std::ranges::all_of(contour.points, [&](const Point3& p) {
            return std::abs(p.x - contour.points[0].x) + std::abs(p.y - contour.points[0].y) < 1e-4;
        });
    });
    return set;
}

TEST(ContourNesting, at_the_height_of_vertices_is_that_of_the_level_just_below) {
    std::mt19937_64 random(13);
    std::size_t touching = 0;
    for (int round = 0; round < 400; ++round) {
        const auto n = static_cast<shapes::Index>(3 + random() % 12);
        const std::uint64_t heights = 2 + random() % 4;  // few: ridges and plateaus everywhere
        std::vector<double> height(std::size_t(n + 1) * (n + 1));
        for (double& h : height) h = static_cast<double>(random() % heights);
        if (round % 2) add_waves(height, n, static_cast<double>(heights - 1));
        const auto soup = shapes::terrain(
            n, [&](double x, double y) { return height[std::size_t(y) * (n + 1) + std::size_t(x)]; });
        const double level = static_cast<double>(1 + random() % (heights - 1));
        const auto exact = level_of(soup, level);
        const auto below = without_points(level_of(soup, level - 1e-5));
        ASSERT_EQ(exact.contours.size(), below.contours.size());
        const auto nesting = nest_contours(exact);
        expect_sound(exact, nesting);
        ASSERT_EQ(nesting.parent, parents_by_all_pairs(below)) << "round " << round;
        double apart = 0;  // a ring has no points twice but where it touches itself or another
        std::vector<std::pair<double, double>> points;
        for (const auto& contour : exact.contours)
            for (const auto& p : contour.points) points.push_back({p.x, p.y});
        std::ranges::sort(points);
        apart = static_cast<double>(std::unique(points.begin(), points.end()) - points.begin());
        touching += apart < static_cast<double>(points.size());
    }
    EXPECT_GT(touching, 250u);
}

TEST(ContourNesting, a_torus_cut_along_its_top_circle_is_a_ring_with_a_hole) {
    for (const bool turned : {false, true}) {
        auto soup = shapes::torus(3, 1, 30, 12);
        if (turned) std::ranges::reverse(soup.triangles);
        double top = 0;
        for (const auto& p : soup.points) top = std::max(top, p.z);
        const auto set = level_of(soup, top);
        ASSERT_EQ(set.contours.size(), 2u);
        const auto nesting = nest_contours(set);
        ASSERT_EQ(nesting.polygons.size(), 1u);
        EXPECT_GT(set.contours[nesting.polygons[0].outer].plan_area(), 0);
        EXPECT_LT(set.contours[nesting.polygons[0].holes.at(0)].plan_area(), 0);
        EXPECT_NEAR(enclosed_area(set, nesting), 0, 1e-12);
    }
}

TEST(ContourNesting, a_hollow_torus_cut_along_its_top_circle_is_a_hole_with_an_island) {
    const auto torus = shapes::torus(3, 1, 30, 12);
    double top = 0;
    for (const auto& p : torus.points) top = std::max(top, p.z);
    auto soup =
        shapes::joined(shapes::turned_over(torus), shapes::moved(shapes::slab(10, 10, 10), -5, -5, -5));
    for (const bool inside_out : {false, true}) {
        const auto set = level_of(inside_out ? shapes::turned_over(soup) : soup, top);
        ASSERT_EQ(set.contours.size(), 3u);
        const auto nesting = nest_contours(set);
        expect_sound(set, nesting);
        ASSERT_EQ(nesting.polygons.size(), 2u);
        for (std::uint32_t c = 0; c < 3; ++c) {
            const double area = set.contours[c].plan_area() * (inside_out ? -1 : 1);
            EXPECT_EQ(nesting.depth[c], area > 99 ? 0u : area < 0 ? 1u : 2u);
        }
        EXPECT_NEAR(enclosed_area(set, nesting), 100, 1e-12);
    }
}

TEST(ContourNesting, of_solids_at_the_height_of_vertices_is_that_of_the_level_just_below) {
    std::mt19937_64 random(17);
    std::size_t nested = 0;
    for (int round = 0; round < 400; ++round) {
        const auto n = static_cast<shapes::Index>(3 + random() % 10);
        std::vector<double> height(std::size_t(n + 1) * (n + 1));
        for (double& h : height) h = static_cast<double>(random() % 4);
        if (round % 2) add_waves(height, n, 2);
        auto soup = shapes::terrain_solid(
            n, 1, [&](double x, double y) { return height[std::size_t(y) * (n + 1) + std::size_t(x)]; });
        if (round % 3 == 0) soup = shapes::turned_over(soup);
        const double level = static_cast<double>(random() % 3);
        const auto exact = level_of(soup, level);
        const auto below = without_points(level_of(soup, level - 1e-5));
        ASSERT_EQ(exact.contours.size(), below.contours.size());
        const auto nesting = nest_contours(exact);
        expect_sound(exact, nesting);
        ASSERT_EQ(nesting.parent, parents_by_all_pairs(below)) << "round " << round;
        nested += static_cast<std::size_t>(std::ranges::count(nesting.depth, 1u));
    }
    EXPECT_GT(nested, 100u);
}

TEST(ContourNesting, finds_cavities_in_bodies_in_cavities) {
    // Balls around one centre, each second one turned over, and a small one off the centre in the innermost.
    TriangleSoup soup;
    double expected = 0;
    for (int k = 0; k < 9; ++k) {
        const auto ball = shapes::uv_sphere(10 - k, 24, 48);
        soup = shapes::joined(soup, k % 2 ? shapes::turned_over(ball) : ball);
        const double cut = level_of(ball, 0.1).contours.at(0).plan_area();
        expected += k % 2 ? -cut : cut;
    }
    for (const double far : {0.0, 5e6}) {
        const auto set = level_of(shapes::moved(soup, far, -far, 0), 0.1);
        const auto nesting = nest_contours(set);
        ASSERT_EQ(set.contours.size(), 9u);
        EXPECT_EQ(nesting.polygons.size(), 5u);
        for (std::uint32_t k = 0; k < 9; ++k) {
            EXPECT_EQ(nesting.depth[k], k);
            EXPECT_EQ(nesting.parent[k], k == 0 ? kNone : k - 1);
        }
        EXPECT_NEAR(enclosed_area(set, nesting), expected, far > 0 ? 1e-5 : 1e-9);
        EXPECT_NEAR(enclosed_area(set, nesting), signed_area(set), 1e-9 * expected);
    }
}

TEST(ContourNesting, a_plate_with_holes_is_one_polygon) {
    const auto set =
        level_of(shapes::plate(41, 41, [](shapes::Index i, shapes::Index j) { return i % 2 && j % 2; }), 0.3);
    const auto nesting = nest_contours(set);
    ASSERT_EQ(nesting.polygons.size(), 1u);
    EXPECT_EQ(nesting.polygons[0].holes.size(), 400u);
    EXPECT_NEAR(enclosed_area(set, nesting), 41 * 41 - 400, 1e-9);
}

TEST(ContourNesting, area_of_polygons_is_that_of_the_section_along_any_direction) {
    std::mt19937_64 random(14);
    for (const auto& shape : shapes::solids()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (int round = 0; round < 20; ++round) {
            const auto part = [&] { return static_cast<double>(random() % 200) / 100 - 1; };
            Point3 direction{part(), part(), part()};
            if (round < 6) {  // the axes, up and down
                direction = {0, 0, 0};
                std::array{&direction.x, &direction.y, &direction.z}[std::size_t(round) % 3][0] =
                    round < 3 ? 2 : -0.5;
            }
            if (direction == Point3{}) continue;
            const auto field = height_field(mesh, direction);
            for (const auto& set : level_sets(mesh, field, even_levels(field, 7))) {
                const auto nesting = nest_contours(set, direction);
                expect_sound(set, nesting);
                const double area = enclosed_area(set, nesting, direction);
                EXPECT_GE(area, 0) << shape.name;
                EXPECT_NEAR(area, signed_area(set, direction), 1e-6 * (1 + area)) << shape.name;
            }
        }
    }
}

TEST(ContourNesting, area_of_polygons_is_that_of_the_section_for_public_models) {
    const std::filesystem::path folder = STRATAREEB_SOURCE_DIR "/../shared/data/models";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    for (const char* name :
         {"3holes_g3", "adis16480_g24", "block_g3", "casting_g9", "elephant_g3", "fertility_g4",
          "gears_7comp", "menger1_g5", "menger2_g81", "plate3x3_axis_g9", "torus60x30_flat_g1"}) {
        const TriMesh mesh = half_edge_mesh(read_mesh(folder / (std::string(name) + ".ply")));
        for (const Point3& direction : {Point3{0, 0, 1}, Point3{1, 0, 0}, Point3{0.3, -0.5, 1}}) {
            const auto field = height_field(mesh, direction);
            auto levels = even_levels(field, 20);
            for (std::size_t v = 0; v < field.size(); v += field.size() / 20) levels.push_back(field[v]);
            for (const auto& set : level_sets(mesh, field, levels)) {
                const auto nesting = nest_contours(set, direction);
                expect_sound(set, nesting);
                const double area = std::abs(signed_area(set, direction));  // one model is wound inward
                EXPECT_NEAR(enclosed_area(set, nesting, direction), area, 1e-9 * (area + 1)) << name;
            }
        }
    }
}

TEST(ContourNesting, does_not_depend_on_the_order_of_contours) {
    const TriMesh mesh = half_edge_mesh(bench::fractal_terrain(60));
    const auto field = height_field(mesh);
    const auto set = level_sets(mesh, field, even_levels(field, 1))[0];
    const auto nesting = nest_contours(set);
    std::vector<std::uint32_t> order(set.contours.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, std::mt19937_64(15));
    LevelSet shuffled{.level = set.level, .contours = {}};
    for (const auto c : order) shuffled.contours.push_back(set.contours[c]);
    const auto again = nest_contours(shuffled);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto parent = again.parent[k];
        EXPECT_EQ(parent == kNone ? kNone : order[parent], nesting.parent[order[k]]);
    }
}

TEST(ContourNesting, gives_crossing_contours_some_forest) {
    std::mt19937_64 random(16);
    for (int round = 0; round < 200; ++round) {
        LevelSet set;
        for (int c = 0; c < 12; ++c) {
            Contour contour;
            for (std::size_t i = 0; i < 2 + random() % 8; ++i)
                contour.points.push_back({double(random() % 6), double(random() % 6), 0});
            set.contours.push_back(contour);
        }
        set.contours.push_back(set.contours[0]);
        expect_sound(set, nest_contours(set));
    }
}

TEST(ContourNesting, takes_empty_sets_and_open_contours_and_refuses_directions_that_are_none) {
    EXPECT_TRUE(nest_contours({}).polygons.empty());
    const auto set = level_of(shapes::cylinder(9, 1, 2), 0.5, {1, 0, 0});
    ASSERT_EQ(set.contours.size(), 2u);
    const auto nesting = nest_contours(set, {1, 0, 0});
    EXPECT_EQ(nesting.open, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(nesting.polygons.empty());
    EXPECT_EQ(enclosed_area(set, nesting), 0);
    EXPECT_THROW(nest_contours(set, {0, 0, 0}), InvalidInput);
    EXPECT_THROW(nest_contours(set, {0, std::numeric_limits<double>::quiet_NaN(), 0}), InvalidInput);
    EXPECT_THROW(nest_contours(set, {0, 0, std::numeric_limits<double>::infinity()}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
