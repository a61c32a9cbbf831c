// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_touches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {
namespace {

SampledContour circle(double x, double y, double radius, int corners = 48) {
    std::vector<Point3> points;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), 1});
    }
    return contour_by_perimeter(points);
}

// Three in a row: the outer two touch the middle one, each half way across its gap.
TEST(ContourTouches, join_neighbours_across_the_narrowest_gaps) {
    const std::vector<SampledContour> row{circle(0, 0, 1), circle(8, 0, 1), circle(3.6, 0, 2)};
    const auto touches = contour_touches(row, 5);
    ASSERT_EQ(touches.size(), 2u);
    EXPECT_EQ(touches[0].first + touches[0].second, 2u) << "the narrower gap first";
    EXPECT_NEAR(touches[0].place.x, 1.3, 1e-12);
    EXPECT_NEAR(touches[1].place.x, 6.3, 1e-12);
    for (const ContourTouch& touch : touches) {
        EXPECT_NEAR(touch.place.y, 0, 1e-12);
        EXPECT_EQ(touch.place.z, 5);
        const Point3 a = point_at(row[touch.first], touch.first_parameter),
                     b = point_at(row[touch.second], touch.second_parameter);
        EXPECT_NEAR((a.x + b.x) / 2, touch.place.x, 1e-12);
    }
}

TEST(ContourTouches, find_gaps_at_the_middle_of_long_sides) {
    const auto square = contour_by_perimeter({{0, -9, 1}, {0, 9, 1}, {-9, 9, 1}, {-9, -9, 1}});
    const auto touches = contour_touches(std::vector<SampledContour>{square, circle(3, 1, 1)}, 2);
    ASSERT_EQ(touches.size(), 1u);
    EXPECT_NEAR(touches[0].place.x, 1, 1e-12);
    EXPECT_NEAR(touches[0].place.y, 1, 1e-12);
}

TEST(ApproachPlaces, leads_a_contour_to_all_its_places_and_nothing_else) {
    const SampledContour contour = circle(0, 0, 1);
    const std::vector<TouchedPlace> places{{0, {1.2, 0, 3}}, {0.5, {-1.5, 0, 3}}};
    const SampledContour there = approach_places(contour, places, 1, 0.25);
    for (const TouchedPlace& place : places)
        EXPECT_EQ(std::ranges::count(there.points, place.place), 1) << "to the last bit";
    for (const Point3& p : there.points) EXPECT_EQ(p.z, 3);
    EXPECT_NEAR(point_at(there, 0.25).y, 1, 1e-12) << "far from both it stays";
    const SampledContour start = approach_places(contour, places, 0, 0.25);
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point3 p = point_at(start, contour.parameters[i]);
        EXPECT_NEAR(std::hypot(p.x - contour.points[i].x, p.y - contour.points[i].y, p.z - 1), 0, 1e-12);
    }
    // Half way up, a quarter ellipse has gone less than half the way across.
    const Point3 middle = point_at(approach_places(contour, places, 0.5, 0.25), 0);
    EXPECT_DOUBLE_EQ(middle.z, 2);
    EXPECT_NEAR(middle.x, 1 + 0.2 * (1 - std::sqrt(0.75)), 1e-12);
}

}  // namespace
}  // namespace stratareeb
