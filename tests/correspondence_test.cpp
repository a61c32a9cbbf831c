// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/correspondence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "boreholes/errors.h"
#include "reeb/plane_frame.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::expect_near;
using curve_cases::Random;
using curve_cases::wavy_ring;
using std::numbers::pi;
using Points = std::vector<Point3>;

Points mapped(Points points, const std::function<Point3(const Point3&)>& map) {
    for (auto& p : points) p = map(p);
    return points;
}

Points shifted(Points points, std::size_t by) {
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(by), points.end());
    return points;
}

std::function<Point3(const Point3&)> turn_about_z(double angle) {
    return [=](const Point3& p) {
        return Point3{std::cos(angle) * p.x - std::sin(angle) * p.y,
                      std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
    };
}

//! The two places that a correspondence brings together.
std::pair<Point3, Point3> places(const Points& f, const Points& g,
                                 const CorrespondenceOptions& options = {}) {
    const auto a = contour_by_perimeter(f), b = contour_by_perimeter(g);
    const auto found = correspond(a, b, options);
    return {point_at(a, found.first), point_at(b, found.second)};
}

TEST(Correspondence, is_the_closest_pair_of_the_images_in_the_unit_square) {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        const auto f = wavy_ring(random, 3 + random.below(40), 0),
                   g = wavy_ring(random, 3 + random.below(40), 1);
        const auto image = [](const Points& points) {
            const auto [left, right] =
                std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.x < b.x; });
            const auto [low, high] =
                std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
            return mapped(points, [=](const Point3& p) {
                return Point3{(right->x - p.x) / (right->x - left->x), (high->y - p.y) / (high->y - low->y),
                              0};
            });
        };
        const auto mf = image(f), mg = image(g);
        double best = 9, second = 9;  // few points: several pairs of corners may coincide
        std::pair<Point3, Point3> expected;
        for (std::size_t i = 0; i < f.size(); ++i) {
            for (std::size_t j = 0; j < g.size(); ++j) {
                const double distance = magnitude(mf[i] - mg[j]);
                second = std::min(second, std::max(best, distance));
                if (distance >= best) continue;
                best = distance;
                expected = {f[i], g[j]};
            }
        }
        const auto found = places(f, g);
        if (second - best > 1e-9) {
            expect_near(found.first, expected.first, 1e-12);
            expect_near(found.second, expected.second, 1e-12);
        }
        EXPECT_NEAR(correspond(contour_by_perimeter(f), contour_by_perimeter(g)).distance, best, 1e-12);
    }
}

TEST(Correspondence, stays_when_contours_start_elsewhere) {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const auto f = wavy_ring(random, 50, 0), g = wavy_ring(random, 70, 1);
        const auto before = places(f, g);
        const auto after = places(shifted(f, random.below(50)), shifted(g, random.below(70)));
        EXPECT_EQ(before, after);
    }
}

TEST(Correspondence, stays_when_each_contour_is_moved_and_scaled_in_its_plane) {
    Random random(3);
    for (int round = 0; round < 100; ++round) {
        const auto f = wavy_ring(random, 50, 0), g = wavy_ring(random, 70, 1);
        const auto before = places(f, g);
        const auto f_map = [&](const Point3& p) { return Point3{4 * p.x + 100, 0.5 * p.y - 7, p.z - 3}; };
        const auto g_map = [&](const Point3& p) { return Point3{2 * p.x, 8 * p.y + 1000, p.z + 5}; };
        const auto after = places(mapped(f, f_map), mapped(g, g_map));
        expect_near(after.first, f_map(before.first), 1e-9);
        expect_near(after.second, g_map(before.second), 1e-9);
    }
}

TEST(Correspondence, stays_when_both_contours_turn_in_their_plane) {
    Random random(4);
    for (int round = 0; round < 100; ++round) {
        const auto f = wavy_ring(random, 50, 0), g = wavy_ring(random, 70, 1);
        for (const auto axes : {RectangleAxes::Plane, RectangleAxes::Principal}) {
            const bool any_angle = axes == RectangleAxes::Principal;
            const auto map = turn_about_z(any_angle ? random.uniform(0, 2 * pi)
                                                    : pi / 2 * static_cast<double>(random.below(4)));
            const auto before = places(f, g, {.axes = axes});
            const auto after = places(mapped(f, map), mapped(g, map), {.axes = axes});
            expect_near(after.first, map(before.first), 1e-9);
            expect_near(after.second, map(before.second), 1e-9);
        }
    }
}

TEST(Correspondence, stays_when_the_plane_is_tilted_any_way) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        const auto f = wavy_ring(random, 50, 0), g = wavy_ring(random, 70, 1);
        const auto before = places(f, g);
        // Upper sides stay upper sides: a turn by less than a right angle; or exactly a right one, to a vertical plane.
        Point3 normal = random.point();
        normal.z = round % 4 == 0 ? 0 : std::abs(normal.z);
        if (round % 8 == 0) normal = {0, 1, 0};
        const PlaneFrame frame = plane_frame(normal);
        const auto map = [&](const Point3& p) { return p.x * frame.u + p.y * frame.v + p.z * frame.w; };
        const auto after = places(mapped(f, map), mapped(g, map));
        // A vertical plane is seen from its y side: what was seen from below may be mirrored, never one of the two alone.
        if (normal.z > 0 || normal.y > 0) {
            expect_near(after.first, map(before.first), 1e-9);
            expect_near(after.second, map(before.second), 1e-9);
        }
    }
}

TEST(Correspondence, stays_when_both_contours_run_clockwise_in_any_plane) {
    Random random(6);
    for (int round = 0; round < 100; ++round) {
        const PlaneFrame frame = plane_frame(round % 2 == 0 ? Point3{0, 0, 1} : random.point());
        const auto map = [&](const Point3& p) { return p.x * frame.u + p.y * frame.v + p.z * frame.w; };
        auto f = mapped(wavy_ring(random, 50, 0), map), g = mapped(wavy_ring(random, 70, 1), map);
        const auto before = places(f, g);
        std::reverse(f.begin(), f.end());
        std::reverse(g.begin(), g.end());
        const auto after = places(f, g);
        expect_near(after.first, before.first, 1e-12);
        expect_near(after.second, before.second, 1e-12);
    }
}

TEST(Correspondence, same_shape_at_another_size_corresponds_point_by_point) {
    Random random(7);
    const auto f = wavy_ring(random, 1000, 0);
    const auto g = shifted(mapped(f, [](const Point3& p) { return Point3{3 * p.x, 3 * p.y, 5}; }), 321);
    const auto strand = corresponding_contours({contour_by_perimeter(f), contour_by_perimeter(g)});
    for (double s = 0; s < 1; s += 0.01) {
        const Point3 p = point_at(strand[0], s);
        expect_near(point_at(strand[1], s), {3 * p.x, 3 * p.y, 5}, 1e-9);
    }
}

TEST(Correspondence, a_strand_corresponds_all_the_way) {
    Random random(8);
    std::vector<SampledContour> contours;
    for (int i = 0; i < 20; ++i)
        contours.push_back(contour_by_perimeter(shifted(wavy_ring(random, 200, i), random.below(200))));
    const auto strand = corresponding_contours(contours);
    EXPECT_EQ(strand[0].points, contours[0].points);
    for (std::size_t i = 0; i + 1 < strand.size(); ++i) {
        EXPECT_NO_THROW(check_contour(strand[i + 1]));
        const auto pair = correspond(strand[i], strand[i + 1]);
        const double apart = std::abs(pair.first - pair.second);
        EXPECT_LT(std::min(apart, 1 - apart), 1e-12) << "a pair that belongs together has one parameter";
    }
}

TEST(Correspondence, contours_without_a_rectangle_are_put_in_the_middle) {
    const Points square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto ring = contour_by_perimeter(square);
    EXPECT_NO_THROW(correspond(contour_by_perimeter({{9, 9, 9}}), ring));
    EXPECT_NEAR(correspond(contour_by_perimeter({{9, 9, 9}}), ring).distance, std::sqrt(0.5), 1e-15);
    const auto line = contour_by_perimeter({{0, 5, 1}, {2, 5, 1}, {4, 5, 1}, {2, 5, 1}});
    EXPECT_NEAR(correspond(line, ring).distance, 0.5, 1e-15) << "end of the line (0, 1/2) to a corner";
    EXPECT_NO_THROW(correspond(line, line, {.axes = RectangleAxes::Principal}));
    EXPECT_NO_THROW(correspond(contour_by_perimeter({{1, 1, 1}, {1, 1, 1}}),
                               contour_by_perimeter({{9, 9, 9}}), {.axes = RectangleAxes::Principal}));
    const auto upright = contour_by_perimeter({{0, 0, 0}, {0, 0, 2}});
    EXPECT_EQ(correspond(upright, upright).distance, 0);
}

TEST(Correspondence, parametric_distance_leaves_parameters_together) {
    const auto ring = contour_by_perimeter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const auto later = with_origin(ring, 0.01);
    const auto found = correspond(ring, later, {.distance = ContourDistance::Parametric});
    EXPECT_NEAR(found.distance, 0.01, 1e-15) << "0 and 0.99 are neighbours";
    const auto strand = corresponding_contours({ring, ring}, {.distance = ContourDistance::Parametric});
    EXPECT_EQ(strand[1].parameters, ring.parameters);
}

TEST(Correspondence, samples_at_even_parameters_on_request) {
    Random random(9);
    const auto f = contour_by_perimeter(wavy_ring(random, 30, 0)),
               g = contour_by_perimeter(wavy_ring(random, 40, 1));
    const auto found = correspond(f, g, {.samples = 64});
    EXPECT_EQ(found.first * 64, std::floor(found.first * 64));
    EXPECT_EQ(found.second * 64, std::floor(found.second * 64));
}

TEST(Correspondence, thousands_of_points_far_from_the_origin) {
    Random random(10);
    auto f = wavy_ring(random, 20000, 0), g = wavy_ring(random, 15000, 1);
    const auto near = places(f, g);
    const auto map = [](const Point3& p) { return p + Point3{5e6, 4e6, 200}; };
    const auto far = places(mapped(f, map), mapped(g, map));
    expect_near(far.first, map(near.first), 0.05);
    expect_near(far.second, map(near.second), 0.05);
}

TEST(Correspondence, contours_that_are_none_are_refused) {
    const auto ring = contour_by_perimeter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    EXPECT_THROW(correspond({}, ring), InvalidInput);
    EXPECT_THROW(correspond(ring, {{{0, 0, std::nan("")}}, {0}}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
