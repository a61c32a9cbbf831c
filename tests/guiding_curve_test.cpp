// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/guiding_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "boreholes/errors.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::expect_near;
using curve_cases::Random;
using curve_cases::wavy_ring;
using std::numbers::pi;

SampledContour ring(const Point3& center, double radius, std::size_t n = 64, bool clockwise = false) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = (clockwise ? -2 : 2) * pi * static_cast<double>(i) / static_cast<double>(n);
        points.push_back(center + Point3{radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return contour_by_perimeter(points);
}

double area(const SampledContour& contour) {
    double sum = 0;
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const Point3 &p = contour.points[i], &q = contour.points[(i + 1) % contour.points.size()];
        sum += (p.x * q.y - q.x * p.y) / 2;
    }
    return sum;
}

bool crosses(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const auto side = [](const Point3& p, const Point3& q, const Point3& r) {
        return cross_product(q - p, r - p).z;
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crosses_itself(const SampledContour& contour) {
    const auto& p = contour.points;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = i + 1; j < p.size(); ++j) {
            if (crosses(p[i], p[i + 1], p[j], p[(j + 1) % p.size()])) return true;
        }
    }
    return false;
}

TEST(QuadrantGuidingCurve, passes_through_its_three_points) {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        const QuadrantGuidingCurve c{random.point(5), random.point(5), random.point(5)};
        EXPECT_EQ(c.at(0), c.start);
        EXPECT_EQ(c.at(0.5), c.critical);
        EXPECT_EQ(c.at(1), c.end);
        expect_near(c.at(1e-12), c.start, 1e-9);
        expect_near(c.at(0.5 - 1e-14), c.critical, 1e-5);
        expect_near(c.at(0.5 + 1e-14), c.critical, 1e-5);
        expect_near(c.at(1 - 1e-12), c.end, 1e-9);
    }
}

TEST(QuadrantGuidingCurve, halves_are_quarters_of_ellipses) {
    const QuadrantGuidingCurve c{{-3, 0, 0}, {0, 0, 2}, {0, 5, -1}};
    for (double t = 0; t <= 0.5; t += 0.01) {
        const Point3 p = c.at(t), q = c.at(1 - t);
        EXPECT_NEAR(p.x * p.x / 9 + p.z * p.z / 4, 1, 1e-12) << "centre (0, 0, 0), upright where it starts";
        EXPECT_NEAR(q.y * q.y / 25 + (q.z + 1) * (q.z + 1) / 9, 1, 1e-7);
    }
}

TEST(QuadrantGuidingCurve, is_level_at_the_critical_point_and_upright_at_the_contours) {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const QuadrantGuidingCurve c{random.point(), random.point() + Point3{0, 0, 3}, random.point()};
        const auto steepness = [](const Point3& from, const Point3& to) {
            return std::abs(to.z - from.z) / std::hypot(to.x - from.x, to.y - from.y);
        };
        double before = std::numeric_limits<double>::infinity();
        for (const double h : {1e-2, 1e-4, 1e-6}) {
            const double steepest =
                std::max(steepness(c.at(0.5 - h), c.critical), steepness(c.at(0.5 + h), c.critical));
            EXPECT_LT(steepest, before / 5) << "goes to 0 as the square root of the step";
            before = steepest;
        }
        EXPECT_GT(steepness(c.start, c.at(1e-6)), 1e3);
        EXPECT_GT(steepness(c.end, c.at(1 - 1e-6)), 1e3);
    }
}

TEST(HatWeight, is_one_at_its_place_even_to_its_feet_and_goes_round) {
    EXPECT_EQ(hat_weight(0.3, 0.3, 0.1, 0.2), 1);
    EXPECT_NEAR(hat_weight(0.25, 0.3, 0.1, 0.2), 0.5, 1e-12);
    EXPECT_NEAR(hat_weight(0.35, 0.3, 0.1, 0.2), 0.75, 1e-12);
    EXPECT_EQ(hat_weight(0.19, 0.3, 0.1, 0.2), 0);
    EXPECT_EQ(hat_weight(0.51, 0.3, 0.1, 0.2), 0);
    EXPECT_NEAR(hat_weight(0.95, 0.05, 0.2, 0.2), 0.5, 1e-12);
    EXPECT_NEAR(hat_weight(0.05, 0.95, 0.2, 0.2), 0.5, 1e-12);
    for (double s = 0; s < 1; s += 0.01) {
        EXPECT_GE(hat_weight(s, 0.7, 0.5, 0.5), 0);
        EXPECT_LE(hat_weight(s, 0.7, 0.5, 0.5), 1);
    }
}

TEST(GuidedContour, passes_through_its_targets_and_is_the_contour_out_of_reach) {
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        const auto contour = contour_by_perimeter(wavy_ring(random, 20 + random.below(80), 1));
        const std::vector<Guide> guides{{random.uniform(0.1, 0.2), random.point(3), 0.1, 0.15},
                                        {random.uniform(0.4, 0.6), random.point(3), 0.15, 0.05},
                                        {contour.parameters.back(), random.point(3), 0.05, 0.001}};
        const auto guided = guided_contour(contour, guides);
        EXPECT_NO_THROW(check_contour(guided));
        for (const auto& g : guides) {
            EXPECT_NE(std::find(guided.points.begin(), guided.points.end(), g.target), guided.points.end());
            expect_near(point_at(guided, g.parameter), g.target, 1e-6);
        }
        for (std::size_t i = 0; i < guided.points.size(); ++i) {
            Point3 expected = point_at(contour, guided.parameters[i]);
            for (const auto& g : guides) {
                const double w = hat_weight(guided.parameters[i], g.parameter, g.before, g.after);
                expected += w * (g.target - point_at(contour, g.parameter));
            }
            expect_near(guided.points[i], expected, 1e-6);
        }
    }
}

TEST(GuidedContour, without_a_way_to_go_is_the_contour_itself) {
    Random random(4);
    const auto contour = contour_by_perimeter(wavy_ring(random, 50, 1));
    const Guide stay{0.3, point_at(contour, 0.3), 0.2, 0.2};
    const auto guided = guided_contour(contour, std::span(&stay, 1));
    for (double s = 0; s < 1; s += 0.003) expect_near(point_at(guided, s), point_at(contour, s), 1e-12);
    EXPECT_EQ(guided_contour(contour, {}).points, contour.points);
}

TEST(GuidedContour, guides_in_each_others_way_are_refused) {
    const auto contour = ring({0, 0, 0}, 1);
    const std::vector<Guide> near{{0.1, {}, 0.2, 0.2}, {0.2, {}, 0.2, 0.2}};
    EXPECT_THROW(guided_contour(contour, near), InvalidInput);
    for (const double reach : {0.0, -0.1, 0.6, std::nan("")}) {
        const Guide bad{0.1, {}, reach, 0.2};
        EXPECT_THROW(guided_contour(contour, std::span(&bad, 1)), InvalidInput);
    }
    EXPECT_THROW(guided_contour({}, {}), InvalidInput);
}

TEST(GuidingCurve, nearest_place_is_that_of_dense_sampling) {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        const auto contour =
            with_origin(contour_by_perimeter(wavy_ring(random, 12, 1)), random.uniform(0, 1));
        const Point3 point = random.point(2);
        const double s = nearest_parameter(contour, point);
        EXPECT_GE(s, 0);
        EXPECT_LT(s, 1);
        const auto distance = [&](const Point3& p) { return std::hypot(p.x - point.x, p.y - point.y); };
        double best = 99;
        for (const auto& p : points_at(contour, even_parameters(5000))) best = std::min(best, distance(p));
        EXPECT_NEAR(distance(point_at(contour, s)), best, 2e-3);
        EXPECT_LE(distance(point_at(contour, s)), best + 1e-12);
    }
}

//! A contour with a waist: two lobes around (-1.5, 0) and (1.5, 0), half a unit apart from the middle above and below.
SampledContour dumbbell(double z) {
    std::vector<Point3> points;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2 * pi * i / 200, r = 2 - 1.5 * std::pow(std::sin(angle), 2);
        points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    return contour_by_perimeter(points);
}

TEST(GuidingCurve, pinches_a_contour_at_both_sides_of_its_waist) {
    const auto contour = dumbbell(0);
    const auto [a, b] = pinch_parameters(contour, {0, 0.1, 0});
    expect_near(point_at(contour, a), {0, 0.5, 0}, 0.02);
    expect_near(point_at(contour, b), {0, -0.5, 0}, 0.02);
    EXPECT_THROW(pinch_parameters(contour, {0, 5, 0}), InvalidInput);
    EXPECT_THROW(pinch_parameters(contour_by_perimeter({{1, 1, 1}}), {0, 0, 0}), InvalidInput);
}

TEST(Approach, starts_as_the_contour_ends_at_the_critical_point_and_follows_quadrants) {
    Random random(6);
    for (int round = 0; round < 50; ++round) {
        const auto contour = contour_by_perimeter(wavy_ring(random, 100, 0));
        const Point3 critical{2, 0.3, 3};
        const std::vector<double> place{nearest_parameter(contour, critical)};
        const auto start = approach(contour, place, critical, 0);
        for (double s = 0; s < 1; s += 0.01) expect_near(point_at(start, s), point_at(contour, s), 1e-12);
        const QuadrantGuidingCurve guide{point_at(contour, place[0]), critical, {}};
        for (double share = 0.1; share <= 1; share += 0.1) {
            const auto there = approach(contour, place, critical, share);
            for (const auto& p : there.points) EXPECT_NEAR(p.z, 3 * share, 1e-14);
            expect_near(point_at(there, place[0]), guide.at(share / 2), 1e-6);
        }
        const auto end = approach(contour, place, critical, 1);
        EXPECT_EQ(std::count(end.points.begin(), end.points.end(), critical), 1);
        for (const auto& p : end.points) EXPECT_EQ(p.z, 3);
    }
}

TEST(MergedContour, is_an_eight_traced_from_the_critical_point) {
    const std::vector<SampledContour> two{ring({-2, 0, 0}, 1), ring({2, 0, 0}, 1)};
    const Point3 critical{0, 0, 1};
    const std::vector<double> places{nearest_parameter(two[0], critical),
                                     nearest_parameter(two[1], critical)};
    const auto merged = merged_contour(two, places, critical);
    EXPECT_NO_THROW(check_contour(merged));
    EXPECT_EQ(merged.points[0], critical);
    EXPECT_EQ(std::count(merged.points.begin(), merged.points.end(), critical), 2);
    EXPECT_FALSE(crosses_itself(merged));
    const double whole = area(approach(two[0], std::span(&places[0], 1), critical, 1)) +
                         area(approach(two[1], std::span(&places[1], 1), critical, 1));
    EXPECT_NEAR(area(merged), whole, 1e-12);
    EXPECT_GT(whole, 2 * pi);
    // Two alike: each has half of the parameters, the first contour the first half.
    const auto second =
        std::find(merged.points.begin() + 1, merged.points.end(), critical) - merged.points.begin();
    EXPECT_NEAR(merged.parameters[static_cast<std::size_t>(second)], 0.5, 1e-12);
    EXPECT_LT(point_at(merged, 0.25).x, -2);
    EXPECT_GT(point_at(merged, 0.75).x, 2);
    // By perimeter: even parameters are even lengths.
    const double length = perimeter(merged.points);
    for (std::size_t i = 0; i + 1 < merged.points.size(); ++i) {
        EXPECT_NEAR((merged.parameters[i + 1] - merged.parameters[i]) * length,
                    magnitude(merged.points[i + 1] - merged.points[i]), 1e-12);
    }
}

TEST(MergedContour, of_several_at_one_saddle_does_not_cross_itself) {
    for (const bool clockwise : {false, true}) {
        std::vector<SampledContour> rings;
        for (const double turns : {0.3, 0.9, 0.1, 0.5, 0.7}) {  // in no order
            rings.push_back(
                ring({3 * std::cos(2 * pi * turns), 3 * std::sin(2 * pi * turns), 0}, 0.7, 40, clockwise));
        }
        const Point3 critical{0, 0, 1};
        std::vector<double> places;
        for (const auto& r : rings) places.push_back(nearest_parameter(r, critical));
        const auto merged = merged_contour(rings, places, critical);
        EXPECT_EQ(std::count(merged.points.begin(), merged.points.end(), critical), 5);
        EXPECT_FALSE(crosses_itself(merged));
        EXPECT_EQ(area(merged) < 0, clockwise);
        // Drawn apart at the critical point, towards each lobe's middle, it is one simple outline: the order is right.
        auto apart = merged;
        const std::size_t n = apart.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (merged.points[i] != critical) continue;
            apart.points[i] = 0.02 * (merged.points[(i + 1) % n] + merged.points[(i + n - 1) % n]);
        }
        EXPECT_FALSE(crosses_itself(apart));
    }
}

TEST(MergedContour, an_outline_and_its_hole_become_one) {
    const std::vector<SampledContour> both{ring({0, 0, 0}, 3), ring({1, 0, 0}, 1, 40, true)};
    const Point3 critical{2.5, 0, 1};
    const std::vector<double> places{nearest_parameter(both[0], critical),
                                     nearest_parameter(both[1], critical)};
    const auto merged = merged_contour(both, places, critical, 0.1);
    EXPECT_FALSE(crosses_itself(merged));
    EXPECT_NEAR(area(merged),
                area(approach(both[0], std::span(&places[0], 1), critical, 1, 0.1)) +
                    area(approach(both[1], std::span(&places[1], 1), critical, 1, 0.1)),
                1e-12);
}

TEST(DividedContours, are_the_lobes_of_a_waist) {
    const auto contour = dumbbell(0);
    const Point3 critical{0, 0, 1};
    const auto places = pinch_parameters(contour, critical);
    const auto parts = divided_contours(contour, places, critical);
    ASSERT_EQ(parts.size(), 2u);
    double sum = 0;
    for (const auto& part : parts) {
        EXPECT_NO_THROW(check_contour(part));
        EXPECT_EQ(part.points[0], critical);
        EXPECT_EQ(part.parameters[0], 0);
        EXPECT_EQ(std::count(part.points.begin(), part.points.end(), critical), 1);
        EXPECT_FALSE(crosses_itself(part));
        EXPECT_GT(area(part), 0) << "both run as the contour does";
        EXPECT_NEAR(area(part), area(parts[0]), 1e-9) << "the lobes are alike";
        sum += area(part);
        for (const auto& p : part.points) EXPECT_EQ(p.z, 1);
    }
    EXPECT_NEAR(sum, area(approach(contour, places, critical, 1)), 1e-12);
    EXPECT_LT(parts[0].points[5].x * parts[1].points[5].x, 0) << "one on each side";
}

TEST(DividedContours, merge_back_into_the_contour_they_came_from) {
    const auto contour = dumbbell(0);
    const Point3 critical{0, 0, 1};
    const auto places = pinch_parameters(contour, critical);
    const auto parts = divided_contours(contour, places, critical);
    const auto merged = merged_contour(parts, std::vector<double>{0, 0}, critical);
    const auto pinched = approach(contour, places, critical, 1);
    EXPECT_NEAR(perimeter(merged.points), perimeter(pinched.points), 1e-12);
    EXPECT_NEAR(area(merged), area(pinched), 1e-12);
}

TEST(DividedContours, of_three_places_are_three) {
    const auto contour = ring({0, 0, 0}, 1, 90);
    const auto parts = divided_contours(contour, std::vector<double>{0.9, 0.25, 0.6}, {0, 0, 1}, 0.1);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_GT(point_at(parts[0], 0.5).y, 0) << "the first part starts at the first place along the contour";
    for (const auto& part : parts) EXPECT_GT(area(part), 0);
}

TEST(DividedContours, places_that_are_none_are_refused) {
    const auto contour = ring({0, 0, 0}, 1);
    EXPECT_THROW(divided_contours(contour, std::vector<double>{0.5}, {}), InvalidInput);
    EXPECT_THROW(divided_contours(contour, std::vector<double>{0.5, 1.5}, {}), InvalidInput);
    EXPECT_THROW(merged_contour(std::vector{contour}, std::vector<double>{0.5}, {}), InvalidInput);
    EXPECT_THROW(merged_contour(std::vector{contour, contour}, std::vector<double>{0.5}, {}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
