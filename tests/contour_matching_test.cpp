// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mesh/ring_crossings.h"
#include "reeb/contour_alignment.h"
#include "reeb/contour_warping.h"
#include "reeb/homotopy.h"

namespace stratareeb {
namespace {

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

SampledContour circle(double radius, std::size_t corners, double z, double turn = 0) {
    std::vector<Point3> points;
    for (std::size_t k = 0; k < corners; ++k) {
        const double s = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners) + turn;
        points.push_back({radius * std::cos(s), radius * std::sin(s), z});
    }
    return contour_by_perimeter(points);
}

//! A strip 2 wide and 40 long with a tongue of a length on its right end, its corners spaced about evenly.
SampledContour strip(double tongue, double z, double dx = 0) {
    const std::vector<Point3> corners{{0, 0, z},    {40 + tongue, 0, z}, {40 + tongue, 0.5, z},
                                      {40, 0.5, z}, {40, 2, z},          {0, 2, z}};
    std::vector<Point3> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double length = distance(a, b);
        const auto parts = std::max(1, static_cast<int>(length / 0.7));
        for (int k = 0; k < parts && length > 0; ++k)
            points.push_back({a.x + dx + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts, z});
    }
    return contour_by_perimeter(points);
}

double root_mean_square_way(const SampledContour& a, const SampledContour& b) {
    double sum = 0;
    constexpr std::size_t kPlaces = 1000;
    const auto s = even_parameters(kPlaces);
    const auto p = points_at(a, s), q = points_at(b, s);
    for (std::size_t i = 0; i < kPlaces; ++i) sum += distance(p[i], q[i]) * distance(p[i], q[i]);
    return std::sqrt(sum / kPlaces);
}

TEST(ContourMatching, keeps_parameters_by_length_where_shapes_are_one) {
    const SampledContour first = circle(2, 96, 0);
    for (const double radius : {0.5, 1.9, 2.1, 5.0}) {
        const SampledContour second = circle(radius, 96, 1, 0.3);
        const SampledContour matched = matched_contour(first, second),
                             aligned = with_origin(second, aligned_origin(first, second));
        EXPECT_EQ(matched.points, aligned.points) << radius;
        EXPECT_EQ(matched.parameters, aligned.parameters) << radius;
    }
}

// A tongue of half the strip's length is a third of the perimeter: by length, the rest would slide by up to that.
TEST(ContourMatching, what_is_beside_a_tongue_stays_where_it_is) {
    for (const double tongue : {2.0, 8.0, 20.0}) {
        const SampledContour first = strip(0, 0), second = strip(tongue, 1);
        const SampledContour by_shape = matched_contour(first, second, Matching::ByShape),
                             by_length = matched_contour(first, second, Matching::ByLength);
        for (const double x : {1.0, 10.0, 20.0, 35.0})
            for (const double y : {0.0, 2.0}) {
                const auto at = std::ranges::min_element(second.points, {},
                                                         [&](const Point3& p) {
                                                             return distance(p, {x, y, 0});
                                                         }) -
                                second.points.begin();
                const Point3 here = second.points[static_cast<std::size_t>(at)];
                const auto own = std::ranges::find(by_shape.points, here) - by_shape.points.begin();
                const Point3 there = point_at(first, by_shape.parameters[static_cast<std::size_t>(own)]);
                EXPECT_LT(distance(here, there), 0.15 * tongue + 0.4) << tongue << " at " << x << ", " << y;
            }
        EXPECT_LT(root_mean_square_way(first, by_shape), 0.8 * root_mean_square_way(first, by_length));
    }
}

// As two contours come together so do matched points, however uneven the parameters of the first are.
TEST(ContourMatching, comes_down_to_the_same_contour) {
    SampledContour first = matched_contour(strip(0, 0), strip(20, 1), Matching::ByShape);
    double before = 1e300;
    for (const double gap : {1.0, 0.1, 0.01, 0.001}) {
        const SampledContour second = matched_contour(first, strip(20, 2, gap), Matching::ByShape);
        const double way = root_mean_square_way(first, second);
        EXPECT_LT(way, 4 * gap + 1e-3);
        EXPECT_LT(way, before);
        before = way;
    }
}

// A thin strip that moves sideways by thirty times its width a level: nothing between crosses itself.
TEST(ContourMatching, thin_strips_do_not_cross_on_their_way) {
    const auto bow = [](double width, double bulge, double z, std::size_t n) {
        std::vector<Point3> points;
        for (const bool back : {false, true})
            for (std::size_t i = 0; i < n; ++i) {
                const double u = static_cast<double>(back ? n - i : i) / static_cast<double>(n);
                points.push_back(
                    {10 * u, bulge * std::sin(std::numbers::pi * u * 2) + (back ? width : 0), z});
            }
        return contour_by_perimeter(points);
    };
    for (const double bulge : {1.2, 1.5, 2.0}) {
        const SampledContour first = bow(0.05, 1, 0, 60), second = bow(0.05, bulge, 1, 71);
        const ContourHomotopy between({first, matched_contour(first, second, Matching::ByShape)}, {0, 1},
                                      {.kind = HomotopyKind::Linear});
        for (const double t : {0.25, 0.5, 0.75}) {
            std::vector<std::vector<Point2>> ring(1);
            for (const Point3& p : between.contour(0, t).points) ring[0].push_back({p.x, p.y});
            EXPECT_TRUE(ring_crossings(ring, {.most = 1}).empty()) << bulge << " at " << t;
        }
    }
}

TEST(ContourMatching, is_a_contour_with_all_its_points_for_any_two) {
    std::mt19937_64 random(5);
    const auto blob = [&](std::size_t n) {
        std::vector<Point3> points;
        for (std::size_t k = 0; k < n; ++k) {
            const double s = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            const double r = 1 + 0.9 * static_cast<double>(random() % 1000) / 1000;
            points.push_back({r * std::cos(s) + 5e6, r * std::sin(s), 0});
        }
        return contour_by_perimeter(points);
    };
    for (int round = 0; round < 300; ++round) {
        const SampledContour first = blob(3 + random() % 90), second = blob(3 + random() % 90);
        const SampledContour matched = matched_contour(first, second, Matching::ByShape);
        check_contour(matched);
        ASSERT_EQ(matched.points.size(), second.points.size());
        const auto at = std::ranges::find(second.points, matched.points[0]) - second.points.begin();
        for (std::size_t i = 0; i < matched.points.size(); ++i) {
            EXPECT_EQ(matched.points[i],
                      second.points[(static_cast<std::size_t>(at) + i) % second.points.size()]);
            if (i > 0) {
                EXPECT_GT(matched.parameters[i], matched.parameters[i - 1]) << round;
            }
        }
    }
    const SampledContour point = contour_by_perimeter({{1, 2, 3}});
    EXPECT_EQ(matched_contour(point, circle(1, 9, 0)).points.size(), 9u);
    EXPECT_EQ(matched_contours({circle(1, 9, 0), point}).back().points.size(), 1u);
}

// Partners rise with the place and go round once.
TEST(ContourMatching, warps_in_order_once_around) {
    const SampledContour first = strip(0, 0), second = strip(13, 1);
    const ContourWarp warp = contour_warp(first, second, 200);
    double before = warp.partner(0);
    for (int k = 1; k <= 1000; ++k) {
        const double partner = warp.partner(k / 1000.0);
        EXPECT_GE(partner, before - 1e-12);
        before = partner;
    }
    EXPECT_NEAR(warp.partner(1) - warp.partner(0), 1, 1e-12);
}

}  // namespace
}  // namespace stratareeb
