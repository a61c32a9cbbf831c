// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/sampled_contour.h"

#include <gtest/gtest.h>

#include <limits>

#include "boreholes/errors.h"
#include "reeb/band_count.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::expect_near;
using curve_cases::Random;

TEST(SampledContour, parameters_are_shares_of_the_perimeter) {
    const auto contour = contour_by_perimeter({{0, 0, 1}, {3, 0, 1}, {3, 4, 1}});
    EXPECT_EQ(perimeter(contour.points), 12);
    EXPECT_EQ(contour.parameters, (std::vector<double>{0, 3.0 / 12, 7.0 / 12}));
    expect_near(point_at(contour, 10.5 / 12), {0.9, 1.2, 1}, 1e-15, "3.5 of 5 down the long side");
}

TEST(SampledContour, is_its_points_at_their_parameters_to_the_last_bit) {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        auto contour = contour_by_perimeter(random.points(1 + random.below(40), 1e6));
        contour = with_origin(contour, random.uniform(0, 1));
        EXPECT_NO_THROW(check_contour(contour));
        EXPECT_EQ(points_at(contour, contour.parameters), contour.points);
    }
}

TEST(SampledContour, many_points_at_once_are_the_points_one_by_one) {
    Random random(2);
    const auto contour = with_origin(contour_by_perimeter(random.points(17)), 0.37);
    std::vector<double> s;
    for (int i = 0; i < 500; ++i) s.push_back(random.uniform(-2, 3));
    const auto points = points_at(contour, s);
    for (std::size_t i = 0; i < s.size(); ++i) EXPECT_EQ(points[i], point_at(contour, s[i]));
}

TEST(SampledContour, moving_the_origin_moves_no_point) {
    Random random(3);
    for (int round = 0; round < 300; ++round) {
        const auto contour = contour_by_perimeter(random.points(1 + random.below(20)));
        const bool at_vertex = round % 2 == 0;
        const double origin =
            at_vertex ? contour.parameters[random.below(contour.points.size())] : random.uniform(-1, 2);
        const auto moved = with_origin(contour, origin);
        EXPECT_NO_THROW(check_contour(moved)) << "parameters still rise along the contour";
        if (at_vertex) {
            EXPECT_EQ(moved.parameters[0], 0);
        }
        for (double s = 0; s < 1; s += 0.01)
            expect_near(point_at(moved, s), point_at(contour, s + origin), 1e-12);
    }
}

TEST(SampledContour, mean_point_is_the_limit_of_many_samples) {
    Random random(4);
    const auto contour = contour_by_perimeter(random.points(9));
    Point3 sum;
    for (const auto& p : points_at(contour, even_parameters(100000))) sum += 1e-5 * p;
    expect_near(mean_point(contour), sum, 1e-4);
    expect_near(mean_point(contour_by_perimeter({{0, 0, 3}, {2, 0, 3}, {2, 2, 3}, {0, 2, 3}})), {1, 1, 3},
                1e-15);
    EXPECT_EQ(mean_point(contour_by_perimeter({{5e6, 4e6, 7}})), (Point3{5e6, 4e6, 7}));
}

TEST(SampledContour, short_sides_are_the_same_contour) {
    const auto shape =
        with_origin(contour_by_perimeter({{0, 0, 0}, {4, 0, 0}, {4, 2, 1}, {1, 2, 0}, {0, 1.9, 0}}), 0.13);
    const auto fine = with_short_sides(shape, 0.3);
    EXPECT_NO_THROW(check_contour(fine));
    for (std::size_t i = 0; i < shape.points.size(); ++i)
        EXPECT_EQ(point_at(fine, shape.parameters[i]), shape.points[i]);
    for (std::size_t i = 0; i < fine.points.size(); ++i) {
        EXPECT_LE(magnitude(fine.points[(i + 1) % fine.points.size()] - fine.points[i]), 0.3 + 1e-12);
        EXPECT_LT(magnitude(fine.points[i] - point_at(shape, fine.parameters[i])), 1e-12);
    }
    EXPECT_EQ(with_short_sides(shape, 100).points, shape.points);
    const SampledContour point{.points = {{1, 2, 3}}, .parameters = {0}};
    EXPECT_EQ(with_short_sides(point, 0).points, point.points);
}

TEST(SampledContour, bands_are_as_many_as_asked_for_but_not_lower_than_what_shows) {
    const SampledContour square = contour_by_perimeter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    EXPECT_DOUBLE_EQ(point_spacing(square.points), 4 / 96.0);
    const auto fine = with_short_sides(square, 0.01);
    EXPECT_NEAR(point_spacing(fine.points), 0.01, 1e-12);
    const auto slender = contour_by_perimeter({{0, 0, 0}, {100, 0, 0}, {100, 0.1, 0}, {0, 0.1, 0}});
    EXPECT_NEAR(point_spacing(slender.points), 0.1 / 6, 1e-4);
    EXPECT_EQ(bands_across(1, 0.01, 6, 1, 6), 6u);
    EXPECT_EQ(bands_across(0.03, 0.01, 6, 1, 6), 6u);
    EXPECT_EQ(bands_across(0.0149, 0.01, 6, 1, 6), 3u);
    EXPECT_EQ(bands_across(0.0149, 0.01, 12, 1, 12), 6u);  // finer steps, finer bands
    EXPECT_EQ(bands_across(0, 0.01, 6, 3, 6), 3u);
    EXPECT_EQ(bands_across(0, 0, 6, 1, 6), 6u);
}

TEST(SampledContour, repeated_points_and_contours_without_length_do_no_harm) {
    const auto doubled =
        contour_by_perimeter({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
    EXPECT_NO_THROW(check_contour(doubled));
    EXPECT_EQ(points_at(doubled, doubled.parameters), doubled.points);
    const auto point = contour_by_perimeter({{1, 2, 3}, {1, 2, 3}});
    EXPECT_NO_THROW(check_contour(point));
    EXPECT_EQ(point_at(point, 0.7), (Point3{1, 2, 3}));
    EXPECT_EQ(point_at(contour_by_perimeter({{1, 2, 3}}), 0.9), (Point3{1, 2, 3}));
}

TEST(SampledContour, contours_that_are_none_are_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(contour_by_perimeter({}), InvalidInput);
    EXPECT_THROW(contour_by_perimeter({{0, nan, 0}}), InvalidInput);
    EXPECT_THROW(check_contour({{}, {}}), InvalidInput);
    EXPECT_THROW(check_contour({{{0, 0, 0}}, {0, 0.5}}), InvalidInput);
    EXPECT_THROW(check_contour({{{0, 0, 0}, {1, 0, 0}}, {0.5, 0.2}}), InvalidInput);
    EXPECT_THROW(check_contour({{{0, 0, 0}}, {1}}), InvalidInput);
    EXPECT_THROW(check_contour({{{0, 0, 0}}, {nan}}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
