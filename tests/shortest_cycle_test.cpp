// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/shortest_cycle.h"

#include <gtest/gtest.h>

#include "reeb/coarse_to_fine.h"
#include "reeb/greedy_band.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

constexpr std::array kCosts{BandCost::Area, BandCost::SpanLength, BandCost::ParameterDistance};

SpanContours contours(const Problem& p) {
    return {.upper = p.upper,
            .lower = p.lower,
            .upper_parameters = p.s,
            .lower_parameters = p.t,
            .cost = p.cost,
            .closed = p.closed};
}

//! The path is a cycle, costs what it says, and that is `least`.
void expect_cycle(const Problem& p, const SpanPath& path, double least) {
    ASSERT_EQ(path.upper_advances.size(), p.upper.size() + p.lower.size());
    ASSERT_EQ(std::ranges::count(path.upper_advances, 1), static_cast<std::ptrdiff_t>(p.upper.size()));
    const double tolerance = 1e-11 * (least + 1e-300);
    ASSERT_NEAR(path.cost, cost_along(p, path), tolerance);
    ASSERT_NEAR(path.cost, least, tolerance);
}

void expect_least(Problem p) {
    for (const BandCost cost : kCosts) {
        p.cost = cost;
        const double least = least_cost(p);
        for (const bool corridor : {true, false})
            ASSERT_NO_FATAL_FAILURE(
                expect_cycle(p, shortest_cycle(contours(p), {.corridor = corridor}), least))
                << p.upper.size() << " x " << p.lower.size() << ", cost " << static_cast<int>(cost)
                << ", corridor " << corridor;
        const double tolerance = 1e-11 * least;
        EXPECT_LE(least, greedy_path(contours(p), 0, 0).cost + tolerance);
        EXPECT_LE(least, coarse_to_fine_cycle(contours(p)).cost + tolerance);
    }
}

Problem problem(Points upper, Points lower, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    Problem p{.upper = std::move(upper), .lower = std::move(lower)};
    p.s = even_parameters(p.upper.size(), share(random));
    p.t = even_parameters(p.lower.size(), share(random));
    return p;
}

TEST(ShortestCycle, is_the_least_of_all_cycles_written_down_one_by_one) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> size(2, 4);
    for (int run = 0; run < 1500; ++run) {
        Problem p = problem(grid_points(size(random), 1 + run % 5, random),
                            grid_points(size(random), 1 + run % 5, random), random);
        for (const BandCost cost : kCosts) {
            p.cost = cost;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < p.upper.size(); ++i)
                for (std::size_t j = 0; j < p.lower.size(); ++j)
                    least = std::min(least, enumerated_cost(p, i, j, p.upper.size(), p.lower.size()));
            ASSERT_NO_FATAL_FAILURE(expect_cycle(p, shortest_cycle(contours(p)), least)) << run;
        }
    }
}

TEST(ShortestCycle, is_the_least_from_any_start_on_integer_points_with_ties) {
    std::mt19937 random(2);
    std::uniform_int_distribution<std::size_t> size(2, 18);
    for (int run = 0; run < 2000; ++run)
        ASSERT_NO_FATAL_FAILURE(expect_least(problem(grid_points(size(random), 1 + run % 7, random),
                                                     grid_points(size(random), 1 + run % 7, random), random)))
            << run;
}

TEST(ShortestCycle, is_the_least_from_any_start_on_round_concave_and_noisy_contours) {
    std::mt19937 random(3);
    std::uniform_int_distribution<std::size_t> size(2, 60);
    std::uniform_real_distribution<double> share(0, 1);
    for (int run = 0; run < 700; ++run) {
        const double harmonics = run % 3 == 0 ? 0 : 0.3 * share(random),
                     noise = run % 2 ? 0 : 0.2 * share(random);
        const double height = run % 10 == 0 ? 0 : 3 * share(random);
        Points upper = wobbly_circle(size(random), 1, height, harmonics, noise, random);
        Points lower = wobbly_circle(size(random), 0.2 + 2 * share(random), 0, harmonics, noise, random);
        std::ranges::rotate(lower, lower.begin() + static_cast<std::ptrdiff_t>(random() % lower.size()));
        ASSERT_NO_FATAL_FAILURE(expect_least(problem(std::move(upper), std::move(lower), random))) << run;
    }
}

TEST(ShortestCycle, is_the_least_between_contours_of_very_different_sizes) {
    std::mt19937 random(4);
    for (const std::size_t few : {2, 3, 5, 17})
        for (const std::size_t many : {100, 257, 400}) {
            Points small = wobbly_circle(few, 1, 1, 0, 0, random),
                   big = wobbly_circle(many, 2, 0, 0.1, 0.01, random);
            ASSERT_NO_FATAL_FAILURE(expect_least(problem(small, big, random)));
            ASSERT_NO_FATAL_FAILURE(expect_least(problem(big, small, random)));
        }
}

TEST(ShortestCycle, is_the_least_on_large_coordinates_and_at_all_scales) {
    std::mt19937 random(5);
    for (const double scale : {1e-60, 1e-20, 1e-3, 1e6, 1e30, 1e60}) {
        Points upper = wobbly_circle(90, scale, scale / 10, 0.1, 0.02, random);
        Points lower = wobbly_circle(70, scale, 0, 0.1, 0.02, random);
        ASSERT_NO_FATAL_FAILURE(expect_least(problem(upper, lower, random))) << scale;
    }
    for (int run = 0; run < 20; ++run) {
        Points upper = wobbly_circle(90, 50, 10, 0.1, 0.02, random),
               lower = wobbly_circle(70, 50, 0, 0.1, 0.02, random);
        for (Points* points : {&upper, &lower})
            for (Point3& p : *points) p.x += 500'000, p.y += 5'000'000;
        ASSERT_NO_FATAL_FAILURE(expect_least(problem(upper, lower, random)));
    }
}

TEST(ShortestCycle, is_the_least_where_all_or_most_triangles_have_no_area) {
    std::mt19937 random(6);
    const Points place(40, {1, 2, 3});
    ASSERT_NO_FATAL_FAILURE(expect_least(problem(place, Points(30, {4, 5, 6}), random)));
    ASSERT_NO_FATAL_FAILURE(expect_least(problem(place, place, random)));
    ASSERT_NO_FATAL_FAILURE(expect_least(problem(place, wobbly_circle(50, 1, 0, 0.1, 0, random), random)));
    Points line, other;
    for (int i = 0; i < 50; ++i)
        line.push_back({std::abs(25.0 - i), 0, 0}), other.push_back({std::abs(10.0 - i), 0, 0});
    ASSERT_NO_FATAL_FAILURE(expect_least(problem(line, other, random)));
}

TEST(ShortestCycle, costs_the_same_with_and_without_corridor_on_larger_contours) {
    std::mt19937 random(7);
    for (int run = 0; run < 12; ++run) {
        const double noise = run % 3 == 0 ? 0.03 : run % 3 == 1 ? 0.001 : 0;
        const Problem p =
            problem(wobbly_circle(300 + 50 * static_cast<std::size_t>(run), 1, 0.2, 0.1, noise, random),
                    wobbly_circle(500, 1, 0, 0.1, noise, random), random);
        ShortestCycleWork work;
        const SpanPath narrow = shortest_cycle(contours(p), {.corridor = true, .work = &work});
        const SpanPath wide = shortest_cycle(contours(p), {.corridor = false});
        EXPECT_NEAR(narrow.cost, wide.cost, 1e-11 * wide.cost);
        EXPECT_LT(work.spans, 4 * p.upper.size() * p.lower.size());
    }
}

TEST(ShortestCycle, does_not_depend_on_where_the_contours_begin_or_which_one_is_up) {
    std::mt19937 random(8);
    Problem p = problem(wobbly_circle(120, 1, 0.3, 0.2, 0.02, random),
                        wobbly_circle(100, 1, 0, 0.2, 0.02, random), random);
    const double least = shortest_cycle(contours(p)).cost;
    for (int run = 0; run < 20; ++run) {
        std::ranges::rotate(p.upper, p.upper.begin() + static_cast<std::ptrdiff_t>(random() % 120));
        std::ranges::rotate(p.lower, p.lower.begin() + static_cast<std::ptrdiff_t>(random() % 100));
        EXPECT_NEAR(shortest_cycle(contours(p)).cost, least, 1e-12 * least);
        std::swap(p.upper, p.lower);
        EXPECT_NEAR(shortest_cycle(contours(p)).cost, least, 1e-12 * least);
        std::swap(p.upper, p.lower);
    }
}

TEST(ShortestCycle, is_the_same_path_in_each_run) {
    std::mt19937 random(9);
    for (int run = 0; run < 100; ++run) {
        const Problem p = problem(grid_points(30, 3, random), grid_points(25, 3, random), random);
        const SpanPath one = shortest_cycle(contours(p)), other = shortest_cycle(contours(p));
        EXPECT_EQ(one.upper, other.upper);
        EXPECT_EQ(one.lower, other.lower);
        EXPECT_EQ(one.upper_advances, other.upper_advances);
    }
}

}  // namespace
}  // namespace stratareeb
