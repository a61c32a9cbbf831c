// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

double twice_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

//! A star about zero: simple whatever its radii.
std::vector<Point2> star(std::size_t corners, std::mt19937_64& random) {
    std::vector<Point2> polygon;
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
        const double radius = 1 + static_cast<double>(random() % 1000) / 100;
        polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return polygon;
}

TEST(TriangulatePolygon, fills_it_once) {
    std::mt19937_64 random(61);
    for (std::size_t corners = 3; corners < 80; ++corners) {
        std::vector<Point2> polygon = star(corners, random);
        if (corners % 2) std::ranges::reverse(polygon);
        double expected = 0, sum = 0;
        for (std::size_t i = 0; i < corners; ++i)
            expected += twice_area({0, 0}, polygon[i], polygon[(i + 1) % corners]);
        const auto triangles = triangulate_polygon(polygon);
        EXPECT_EQ(triangles.size(), corners - 2);
        for (const auto& [a, b, c] : triangles) {
            EXPECT_GT(twice_area(polygon[a], polygon[b], polygon[c]), 0);
            sum += twice_area(polygon[a], polygon[b], polygon[c]);
        }
        EXPECT_NEAR(sum, std::abs(expected), 1e-9 * sum);
    }
}

TEST(TriangulatePolygon, refuses_what_is_not_simple) {
    EXPECT_THROW(triangulate_polygon(std::vector<Point2>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}), InvalidInput);
    EXPECT_THROW(triangulate_polygon(std::vector<Point2>{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 0}, {-1, -1}}),
                 InvalidInput);
    EXPECT_THROW(triangulate_polygon(std::vector<Point2>{{0, 0}, {1, 0}}), InvalidInput);
    EXPECT_THROW(triangulate_polygon(std::vector<Point2>{{0, 0}, {1, 0}, {2, 0}}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
