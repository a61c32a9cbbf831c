// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/clip_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace stratareeb {
namespace {

constexpr double kTolerance = 1e-9;

PlanLines line(const Point2& a, const Point2& b) {
    return {{a, b}, {{0, 1}}};
}

double length(const PlanLines& lines) {
    double sum = 0;
    for (const auto& [a, b] : lines.segments)
        sum += std::hypot(lines.points[a].x - lines.points[b].x, lines.points[a].y - lines.points[b].y);
    return sum;
}

double distance_to(const PlanLines& lines, const Point2& p) {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [i, j] : lines.segments) {
        const Point2 &a = lines.points[i], &b = lines.points[j];
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        best = std::min(best, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
    return best;
}

const Footprint kSquare{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
const Footprint kWindow{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{3, 3}, {3, 7}, {7, 7}, {7, 3}}};
const Footprint kComb{
    {{0, 0}, {10, 0}, {10, 10}, {8, 10}, {8, 2}, {6, 2}, {6, 10}, {4, 10}, {4, 2}, {2, 2}, {2, 10}, {0, 10}}};

//! A star with a star-shaped hole, corners at random radii.
Footprint random_star(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Footprint star(2);
    constexpr int kCorners = 17;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5 * share(random)) / kCorners;
        const double outer = 5 + 5 * share(random), inner = 1 + 2 * share(random);
        star[0].push_back({outer * std::cos(angle), outer * std::sin(angle)});
        star[1].push_back({inner * std::cos(angle), -inner * std::sin(angle)});
    }
    return star;
}

TEST(ClipLines, has_the_length_of_the_closed_form) {
    EXPECT_NEAR(length(clipped_lines(line({-5, 5}, {15, 5}), kSquare, kTolerance)), 10, 1e-12);
    EXPECT_NEAR(length(clipped_lines(line({-5, -5}, {15, 15}), kSquare, kTolerance)),
                10 * std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(length(clipped_lines(line({-5, 5}, {15, 5}), kWindow, kTolerance)), 6, 1e-12);
    EXPECT_NEAR(length(clipped_lines(line({-5, 5}, {15, 5}), kComb, kTolerance)), 6, 1e-12);
    EXPECT_NEAR(length(clipped_lines(line({-5, 1}, {15, 1}), kComb, kTolerance)), 10, 1e-12);
}

TEST(ClipLines, keeps_what_is_inside_to_the_bit_and_drops_what_is_outside) {
    const PlanLines lines{{{1, 1}, {2.1, 1.3}, {4, 2}, {20, 20}, {30, 20}, {5, 5}}, {{0, 1}, {1, 2}, {3, 4}}};
    const PlanLines found = clipped_lines(lines, kSquare, kTolerance);
    EXPECT_EQ(found.points, (std::vector<Point2>{{1, 1}, {2.1, 1.3}, {4, 2}}));
    EXPECT_EQ(found.segments, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}}));
}

TEST(ClipLines, of_nothing_is_nothing) {
    EXPECT_TRUE(clipped_lines({}, kSquare, kTolerance).points.empty());
}

TEST(ClipLines, keeps_a_line_from_side_to_side_whole) {
    const PlanLines found = clipped_lines(line({0, 4}, {10, 6}), kSquare, kTolerance);
    EXPECT_EQ(found.points, (std::vector<Point2>{{0, 4}, {10, 6}}));
    EXPECT_EQ(found.segments.size(), 1u);
}

TEST(ClipLines, ends_within_the_tolerance_of_a_ring_make_no_new_point) {
    const PlanLines found = clipped_lines(line({-1e-10, 4}, {10 + 1e-10, 6}), kSquare, kTolerance);
    EXPECT_EQ(found.points.size(), 2u);
    EXPECT_EQ(found.segments.size(), 1u);
}

TEST(ClipLines, through_a_corner_is_not_lost_nor_doubled) {
    const PlanLines found = clipped_lines(line({-4, -4}, {14, 14}), kWindow, kTolerance);
    EXPECT_NEAR(length(found), 6 * std::numbers::sqrt2, 1e-12);
    EXPECT_EQ(found.segments.size(), 2u);
}

TEST(ClipLines, shares_the_points_of_lines_that_meet) {
    const PlanLines cross{{{5, 2}, {-3, 2}, {12, 2}, {5, -3}}, {{0, 1}, {0, 2}, {0, 3}}};
    const PlanLines found = clipped_lines(cross, kSquare, kTolerance);
    EXPECT_EQ(found.segments.size(), 3u);
    EXPECT_EQ(found.points.size(), 4u);
    for (const auto& [a, b] : found.segments)
        EXPECT_TRUE(found.points[a] == (Point2{5, 2}) || found.points[b] == (Point2{5, 2}));
}

// Oracle: places along each line are covered exactly if they lie inside.
TEST(ClipLines, covers_the_places_inside_and_no_others) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Footprint star = random_star(seed);
        std::mt19937_64 random(seed + 1000);
        std::uniform_real_distribution<double> anywhere(-12, 12);
        for (int n = 0; n < 20; ++n) {
            const Point2 a{anywhere(random), anywhere(random)}, b{anywhere(random), anywhere(random)};
            const PlanLines found = clipped_lines(line(a, b), star, kTolerance);
            constexpr int kSamples = 300;
            int inside = 0;
            for (int k = 0; k < kSamples; ++k) {
                const double t = (k + 0.5) / kSamples;
                const Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
                const bool covered = distance_to(found, p) < 1e-9;
                ASSERT_EQ(covered, is_inside(star, p)) << "seed " << seed << ", " << p.x << " " << p.y;
                inside += covered;
            }
            const double full = std::hypot(b.x - a.x, b.y - a.y);
            EXPECT_NEAR(length(found), full * inside / kSamples, full * 12 / kSamples);
            for (const auto& [i, j] : found.segments)
                EXPECT_GT(
                    std::hypot(found.points[i].x - found.points[j].x, found.points[i].y - found.points[j].y),
                    kTolerance);
        }
    }
}

TEST(InsideTest, agrees_with_the_plain_even_odd_rule) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Footprint star = random_star(seed);
        const InsideTest quick(star);
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-11, 11);
        for (int n = 0; n < 2000; ++n) {
            const Point2 p{anywhere(random), anywhere(random)};
            ASSERT_EQ(quick(p), is_inside(star, p)) << p.x << " " << p.y;
        }
    }
    const InsideTest comb(kComb);
    for (double x = -0.5; x < 11; x += 0.25)
        for (double y = -0.5; y < 11; y += 0.25)
            EXPECT_EQ(comb({x, y}), is_inside(kComb, {x, y})) << x << " " << y;
}

TEST(InsideTest, has_no_place_beyond_the_outline) {
    const InsideTest inside(kSquare);
    for (const Point2& p : {Point2{5, -1e300}, {5, 1e300}, {-1, 5}, {11, 5}, {5, NAN}, {NAN, 5}})
        EXPECT_FALSE(inside(p));
}

}  // namespace
}  // namespace stratareeb
