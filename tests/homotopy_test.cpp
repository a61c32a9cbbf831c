// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/homotopy.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/correspondence.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::expect_near;
using curve_cases::Random;
using curve_cases::wavy_ring;
using std::numbers::pi;

constexpr std::array kKinds{HomotopyKind::Linear,   HomotopyKind::Parabola,   HomotopyKind::Quadrant,
                            HomotopyKind::Cardinal, HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic};

struct Strand {
    std::vector<SampledContour> contours;
    std::vector<double> heights;
};

Strand random_strand(Random& random, std::size_t n, std::size_t points) {
    Strand strand;
    double z = random.uniform(-1, 1);
    for (std::size_t i = 0; i < n; ++i) {
        strand.contours.push_back(contour_by_perimeter(wavy_ring(random, points + random.below(points), z)));
        strand.heights.push_back(z);
        z += random.uniform(0.2, 1);
    }
    strand.contours = corresponding_contours(std::move(strand.contours));
    return strand;
}

std::vector<Point3> ring(double radius, double z, std::size_t n = 60) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return points;
}

TEST(ContourHomotopy, is_the_given_contours_at_their_heights_to_the_last_bit) {
    Random random(1);
    for (int round = 0; round < 20; ++round) {
        const auto strand = random_strand(random, 2 + random.below(8), 30);
        for (const auto kind : kKinds) {
            const ContourHomotopy H(strand.contours, strand.heights, {.kind = kind});
            for (std::size_t i = 0; i < H.intervals(); ++i) {
                EXPECT_EQ(H.contour(i, 0).points, strand.contours[i].points);
                EXPECT_EQ(H.contour(i, 0).parameters, strand.contours[i].parameters);
                EXPECT_EQ(H.contour(i, 1).points, strand.contours[i + 1].points);
                const auto s = even_parameters(17);
                EXPECT_EQ(H.contour_at(s, i, 0), points_at(strand.contours[i], s));
                EXPECT_EQ(H.contour_at(s, i, 1), points_at(strand.contours[i + 1], s));
            }
        }
    }
}

TEST(ContourHomotopy, level_contours_stay_level_at_evenly_rising_heights) {
    Random random(2);
    const auto strand = random_strand(random, 5, 30);
    for (const auto kind : kKinds) {
        const ContourHomotopy H(strand.contours, strand.heights, {.kind = kind, .tension = 0.9});
        for (std::size_t i = 0; i < H.intervals(); ++i) {
            for (double t = 0.05; t < 1; t += 0.05) {
                for (const auto& p : H.contour(i, t).points) EXPECT_EQ(p.z, H.level(i, t));
                EXPECT_NEAR(H.level(i, t), (1 - t) * strand.heights[i] + t * strand.heights[i + 1], 1e-14);
            }
        }
    }
}

TEST(ContourHomotopy, all_contours_of_an_interval_at_once_are_those_one_by_one) {
    Random random(3);
    const auto strand = random_strand(random, 6, 40);
    for (const auto kind : kKinds) {
        const ContourHomotopy H(strand.contours, strand.heights, {.kind = kind});
        for (const std::size_t steps : {1u, 2u, 3u, 10u}) {
            const auto between = H.contours_between(2, steps);
            ASSERT_EQ(between.size(), steps - 1);
            for (std::size_t i = 1; i < steps; ++i) {
                const double t = static_cast<double>(i) / static_cast<double>(steps);
                EXPECT_EQ(between[i - 1].points, H.contour(2, t).points);
                EXPECT_EQ(between[i - 1].parameters, H.contour(2, t).parameters);
                EXPECT_EQ(between[i - 1].points[7], H.at(between[i - 1].parameters[7], 2, t));
                EXPECT_NO_THROW(check_contour(between[i - 1]));
            }
        }
    }
}

TEST(ContourHomotopy, quadrant_over_a_circle_is_a_ball) {
    const auto equator = contour_by_perimeter(ring(2, 0)), pole = contour_by_perimeter({{0, 0, 2}});
    const ContourHomotopy up({equator, pole}, {0, 2}, {.kind = HomotopyKind::Quadrant});
    const ContourHomotopy down({contour_by_perimeter({{0, 0, -2}}), equator}, {-2, 0},
                               {.kind = HomotopyKind::Quadrant, .direction = HomotopyDirection::Downward});
    for (double t = 0; t <= 1; t += 0.01) {
        for (const auto& p : up.contour(0, t).points) EXPECT_NEAR(magnitude(p), 2, 1e-12);
        for (const auto& p : down.contour(0, t).points) EXPECT_NEAR(magnitude(p), 2, 1e-12);
    }
    EXPECT_EQ(up.contour(0, 0.99).points.size(), 60u) << "a tip takes the points of the other contour";
    EXPECT_EQ(up.contour(0, 1).points.size(), 1u);
}

TEST(ContourHomotopy, parabola_over_a_circle_is_a_paraboloid) {
    const ContourHomotopy H({contour_by_perimeter(ring(1, 0)), contour_by_perimeter({{0, 0, 3}})}, {0, 3},
                            {.kind = HomotopyKind::Parabola});
    for (double t = 0; t < 1; t += 0.05) {
        for (const auto& p : H.contour(0, t).points)
            EXPECT_NEAR(std::hypot(p.x, p.y), 1 - p.z * p.z / 9, 1e-12);
    }
}

//! One-sided difference quotient of H over the height, towards the inside of an interval.
Point3 slope(const ContourHomotopy& H, double s, std::size_t interval, double t, double direction) {
    const double h = 1e-6, height = H.places()[interval + 1] - H.places()[interval];
    return (direction / (h * height)) * (H.at(s, interval, t + direction * h) - H.at(s, interval, t));
}

TEST(ContourHomotopy, surfaces_are_smooth_across_contours_where_claimed) {
    Random random(4);
    for (int round = 0; round < 20; ++round) {
        const auto strand = random_strand(random, 3 + random.below(4), 30);
        for (const auto kind :
             {HomotopyKind::Cardinal, HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic}) {
            const double a = random.uniform(0, 1);
            const ContourHomotopy H(strand.contours, strand.heights,
                                    {.kind = kind, .tension = a, .a = a, .b = a});
            for (std::size_t i = 0; i + 1 < H.intervals(); ++i) {
                const double s = random.uniform(0, 1);
                expect_near(slope(H, s, i, 1, -1), slope(H, s, i + 1, 0, 1), 5e-4);
            }
        }
    }
}

TEST(ContourHomotopy, smooth_kinds_take_cones_as_they_are) {
    std::vector<SampledContour> contours;
    const std::vector<double> heights{0, 1, 1.5, 4};
    for (const double z : heights) contours.push_back(contour_by_perimeter(ring(5 - z, z)));
    for (const auto kind : {HomotopyKind::Linear, HomotopyKind::Cardinal, HomotopyKind::CatmullRom,
                            HomotopyKind::NaturalCubic}) {
        const ContourHomotopy H(contours, heights, {.kind = kind});
        for (std::size_t i = 0; i < 3; ++i) {
            for (const auto& p : H.contour(i, 0.3).points) EXPECT_NEAR(std::hypot(p.x, p.y), 5 - p.z, 1e-12);
        }
    }
}

TEST(ContourHomotopy, tilted_contours_keep_their_tilt) {
    auto low = ring(1, 0), high = ring(1, 3);
    for (auto& p : low) p.z += 0.2 * p.x;
    for (auto& p : high) p.z += 0.4 * p.x;
    const ContourHomotopy H({contour_by_perimeter(low), contour_by_perimeter(high)}, {0, 3},
                            {.kind = HomotopyKind::Linear});
    EXPECT_EQ(H.contour(0, 0).points, low);
    EXPECT_EQ(H.contour(0, 1).points, high);
    for (const auto& p : H.contour(0, 0.5).points) EXPECT_NEAR(p.z, 1.5 + 0.3 * p.x, 1e-3);
}

TEST(ContourHomotopy, mean_is_the_mean_of_many_points) {
    Random random(5);
    const auto strand = random_strand(random, 5, 30);
    for (const auto kind : kKinds) {
        const ContourHomotopy H(strand.contours, strand.heights, {.kind = kind});
        Point3 sum;
        for (const auto& p : H.contour_at(even_parameters(20000), 1, 0.4)) sum += (1 / 20000.0) * p;
        expect_near(H.mean(1, 0.4), sum, 1e-6);
    }
}

TEST(ContourHomotopy, far_from_the_origin_is_the_same_shape) {
    Random random(6);
    auto strand = random_strand(random, 5, 30);
    const ContourHomotopy near(strand.contours, strand.heights);
    const Point3 far_away{5e6, 4e6, 0};
    for (auto& contour : strand.contours) {
        for (auto& p : contour.points) p += far_away;
    }
    const ContourHomotopy far(strand.contours, strand.heights);
    const auto p = near.contour(1, 0.3).points, q = far.contour(1, 0.3).points;
    for (std::size_t i = 0; i < p.size(); ++i) expect_near(q[i] - far_away, p[i], 1e-8);
}

TEST(HorizontalHomotopy, puts_circles_between_circles_at_one_height) {
    std::vector<SampledContour> contours;
    for (const double r : {1.0, 2.0, 4.0}) contours.push_back(contour_by_perimeter(ring(r, 7)));
    for (const auto kind : {HomotopyKind::Linear, HomotopyKind::Cardinal, HomotopyKind::NaturalCubic}) {
        const auto H = horizontal_homotopy(contours, {.kind = kind});
        EXPECT_NEAR(H.places()[2], 3, 0.01) << "the distance walked: 1 and 2";
        for (const auto& p : H.contour(1, 0.25).points) {
            EXPECT_EQ(p.z, 7);
            EXPECT_NEAR(std::hypot(p.x, p.y), 2.5, 1e-6)
                << "radii are even over the distance, so layers are too";
        }
        EXPECT_EQ(H.contour(1, 0).points, contours[1].points);
    }
    contours[1].points[3].z = 7.5;
    EXPECT_THROW(horizontal_homotopy(contours), InvalidInput);
    EXPECT_THROW(horizontal_homotopy({contours[0], contours[0]}), InvalidInput) << "no way between them";
    EXPECT_THROW(horizontal_homotopy({}), InvalidInput);
}

TEST(HomotopyPlace, finds_the_interval_of_a_height) {
    const std::vector<double> heights{1, 2, 4};
    EXPECT_EQ(homotopy_place(heights, 1).interval, 0u);
    EXPECT_EQ(homotopy_place(heights, 2).interval, 1u);
    EXPECT_EQ(homotopy_place(heights, 2).t, 0);
    EXPECT_EQ(homotopy_place(heights, 3).t, 0.5);
    EXPECT_EQ(homotopy_place(heights, 4).interval, 1u);
    EXPECT_EQ(homotopy_place(heights, 4).t, 1);
    EXPECT_THROW(homotopy_place(heights, 0.9), InvalidInput);
    EXPECT_THROW(homotopy_place(heights, std::nan("")), InvalidInput);
    EXPECT_THROW(homotopy_place({}, 0), InvalidInput);
}

TEST(ContourHomotopy, strands_that_are_none_are_refused) {
    const auto one = contour_by_perimeter(ring(1, 0));
    EXPECT_THROW(ContourHomotopy({one}, {0}), InvalidInput);
    EXPECT_THROW(ContourHomotopy({one, one}, {0}), InvalidInput);
    EXPECT_THROW(ContourHomotopy({one, one}, {0, 0}), InvalidInput);
    EXPECT_THROW(ContourHomotopy({one, one, one}, {0, 1}), InvalidInput);
    EXPECT_THROW(ContourHomotopy({one, SampledContour{}}, {0, 1}), InvalidInput);
}

TEST(HeightScale, is_its_own_inverse_and_rises) {
    for (const bool low : {false, true})
        for (const bool high : {false, true}) {
            const HeightScale scale(1000, 1004, low, high);
            EXPECT_EQ(scale.place(1000), 0);
            EXPECT_EQ(scale.place(1004), 1);
            EXPECT_EQ(scale.height(0), 1000);
            EXPECT_EQ(scale.height(1), 1004);
            double before = 0;
            for (int i = 1; i < 200; ++i) {
                const double z = 1000 + 4 * i / 200.0, place = scale.place(z);
                EXPECT_GT(place, before);
                EXPECT_NEAR(scale.height(place), z, 1e-11);
                before = place;
            }
        }
    EXPECT_NEAR(HeightScale(0, 1, true, false).place(0.09), 0.3, 1e-15);
    EXPECT_NEAR(HeightScale(0, 1, false, true).place(0.91), 0.7, 1e-15);
    EXPECT_NEAR(HeightScale(0, 1, true, true).place(0.25), 1 / 3.0, 1e-15);
}

// Of a sphere, contours over the round scale are r(p) = sin(pi p): far nearer than over heights, where they spread like a root.
TEST(ContourHomotopy, of_round_pace_is_a_sphere_where_contours_are_of_one) {
    std::vector<SampledContour> contours{{.points = {{0, 0, -1}}, .parameters = {0}}};
    std::vector<double> heights{-1};
    for (int i = 1; i < 8; ++i) {
        const double z = -1 + 0.25 * i;
        contours.push_back(contour_by_perimeter(ring(std::sqrt(1 - z * z), z)));
        heights.push_back(z);
    }
    contours.push_back({.points = {{0, 0, 1}}, .parameters = {0}});
    heights.push_back(1);
    const auto farthest = [&](const ContourHomotopy& H) {
        double most = 0;
        for (std::size_t k = 0; k < H.intervals(); ++k)
            for (int j = 1; j < 10; ++j)
                for (const Point3& p : H.contour(k, j / 10.0).points)
                    most = std::max(most, std::abs(std::hypot(p.x, p.y, p.z) - 1));
        return most;
    };
    const HomotopyOptions round{.kind = HomotopyKind::Cardinal, .pace = HomotopyPace::Round};
    const ContourHomotopy H(contours, heights, round, HeightScale(-1, 1, true, true));
    EXPECT_LT(farthest(H), 5e-3);
    EXPECT_GT(farthest(ContourHomotopy(contours, heights, {.kind = HomotopyKind::Cardinal})), 4e-2);
    for (std::size_t k = 0; k < H.intervals(); ++k) {
        EXPECT_EQ(H.contour(k, 0).points, contours[k].points);
        EXPECT_EQ(H.level(k, 0), heights[k]);
        EXPECT_EQ(H.level(k, 1), heights[k + 1]);
    }
}

}  // namespace
}  // namespace stratareeb
