// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_alignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace stratareeb {
namespace {

SampledContour blob(std::size_t corners, double turn, double x, double y) {
    std::vector<Point3> points;
    for (std::size_t k = 0; k < corners; ++k) {
        const double s = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
        const double radius = 3 + std::cos(s) + 0.7 * std::sin(2 * s) + 0.3 * std::cos(5 * s);
        points.push_back({x + radius * std::cos(s + turn), y + radius * std::sin(s + turn), 0});
    }
    return contour_by_perimeter(points);
}

// The same contour starting elsewhere, moved: the origin found is where it started.
TEST(ContourAlignment, finds_the_same_place_again) {
    std::mt19937_64 random(71);
    for (int round = 0; round < 200; ++round) {
        const SampledContour first = blob(90 + random() % 50, 0, 5, 7);
        const double origin = static_cast<double>(random() % 1000) / 1000;
        SampledContour second = with_origin(first, origin);  // 0 there is `origin` here
        for (Point3& p : second.points) p = {p.x + 100, p.y - 30, p.z + 2};
        const double found = aligned_origin(first, second);
        const double off = found - (1 - origin);
        EXPECT_NEAR(off - std::round(off), 0, 2e-3) << "round " << round;
    }
}

TEST(ContourAlignment, does_not_mind_other_samples_or_noise) {
    std::mt19937_64 random(72);
    const SampledContour first = blob(400, 0, 0, 0);
    for (int round = 0; round < 50; ++round) {
        std::vector<Point3> points = blob(90, 0, 0, 0).points;
        for (Point3& p : points) p.x += 0.1 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
        std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(random() % points.size()));
        const SampledContour second = contour_by_perimeter(points);
        const SampledContour aligned = with_origin(second, aligned_origin(first, second));
        for (const double s : {0.0, 0.25, 0.5, 0.75}) {
            const Point3 a = point_at(first, s), b = point_at(aligned, s);
            EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 0.6);
        }
    }
}

TEST(ContourAlignment, of_points_is_nothing_to_speak_of) {
    const SampledContour point{.points = {{1, 2, 3}}, .parameters = {0}};
    EXPECT_TRUE(std::isfinite(aligned_origin(point, blob(20, 0, 0, 0))));
    EXPECT_EQ(aligned_contours({blob(20, 0, 0, 0)}).size(), 1u);
}

}  // namespace
}  // namespace stratareeb
