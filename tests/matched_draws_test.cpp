// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/matched_draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/error_by_gap.h"
#include "boreholes/errors.h"
#include "boreholes/random_survey.h"

namespace stratareeb {
namespace {

std::vector<Point2> places(HolePlan plan, std::uint64_t seed, std::size_t holes = 60) {
    std::vector<Point2> result;
    for (const Borehole& hole : random_survey({.holes = holes, .seed = seed, .plan = plan}).holes)
        result.push_back(hole.at);
    return result;
}

//! Distances from a grid of places over the square to the nearest hole.
std::vector<double> distances(const std::vector<Point2>& holes) {
    std::vector<double> result;
    for (double x = 5; x < 300; x += 10)
        for (double y = 5; y < 300; y += 10) {
            double least = HUGE_VAL;
            for (const Point2& p : holes) least = std::min(least, std::hypot(p.x - x, p.y - y));
            result.push_back(least);
        }
    return result;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double mean_gap(const std::vector<Point2>& holes, const std::vector<Draw>& draws) {
    std::vector<std::size_t> draw_of(holes.size()), all(holes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (std::size_t d = 0; d < draws.size(); ++d)
        for (const std::size_t h : draws[d]) draw_of[h] = d;
    return mean(gaps_to_other_draws(holes, draw_of, all));
}

TEST(MatchedDraws, leave_every_hole_out_once_and_never_more_than_half) {
    for (const HolePlan plan : {HolePlan::Random, HolePlan::Clustered, HolePlan::Grid, HolePlan::Line})
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const auto holes = places(plan, seed, 12 + 3 * seed);
            const auto draws = matched_draws(holes, distances(holes), 10, seed).draws;
            std::vector<int> times(holes.size(), 0);
            EXPECT_GE(draws.size(), 2u);
            for (const Draw& draw : draws) {
                EXPECT_LE(2 * draw.size(), holes.size());
                EXPECT_TRUE(std::ranges::is_sorted(draw));
                for (const std::size_t h : draw) ++times[h];
            }
            EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(holes.size()));
        }
}

TEST(MatchedDraws, of_evenly_spread_holes_are_folds) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto holes = places(HolePlan::Grid, seed, 49);
        EXPECT_EQ(matched_draws(holes, distances(holes), 10, seed).draws, fold_draws(holes.size(), 10, seed));
    }
}

TEST(MatchedDraws, of_groups_are_as_far_from_the_rest_as_places_are_from_holes) {
    double folds = 0, matched = 0, asked = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto holes = places(HolePlan::Clustered, seed);
        const auto wanted = distances(holes);
        folds += mean_gap(holes, fold_draws(holes.size(), 10, seed));
        matched += mean_gap(holes, matched_draws(holes, wanted, 10, seed).draws);
        asked += mean(wanted);
    }
    EXPECT_LT(folds, 0.5 * asked);
    EXPECT_GT(matched, 2 * folds);
    EXPECT_LT(matched, 1.2 * asked);
}

TEST(MatchedDraws, need_two_folds_and_as_many_holes) {
    const auto holes = places(HolePlan::Random, 1, 5);
    EXPECT_THROW(matched_draws(holes, {1.0}, 6, 1), InvalidInput);
    EXPECT_THROW(matched_draws(holes, {1.0}, 1, 1), InvalidInput);
    EXPECT_EQ(matched_draws(holes, {}, 5, 1).draws, fold_draws(5, 5, 1));
}

}  // namespace
}  // namespace stratareeb
