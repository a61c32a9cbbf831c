// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/pinched_band.h"

#include <gtest/gtest.h>

#include "reeb/shortest_cycle.h"
#include "reeb/toroidal_graph.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

Points circle_at(std::size_t count, double x, double z) {
    std::mt19937 unused;
    Points points = wobbly_circle(count, 1, z, 0, 0, unused);
    for (Point3& p : points) p.x += x;
    return points;
}

//! All cycles between two contours, and the cheapest that is not pinched.
double least_open_cost(const Problem& p, SpanPath& path, std::size_t i, std::size_t j, std::size_t up,
                       std::size_t low) {
    if (up + low == 0)
        return is_pinched(path) ? std::numeric_limits<double>::infinity() : cost_along(p, path);
    double best = std::numeric_limits<double>::infinity();
    for (const bool moves_up : {true, false}) {
        if ((moves_up ? up : low) == 0) continue;
        path.upper_advances.push_back(moves_up);
        best = std::min(
            best, least_open_cost(p, path, i + moves_up, j + !moves_up, up - moves_up, low - !moves_up));
        path.upper_advances.pop_back();
    }
    return best;
}

TEST(PinchedBand, is_told_by_its_steps) {
    EXPECT_TRUE(is_pinched({.upper_advances = {1, 1, 0, 0, 0}}));
    EXPECT_TRUE(is_pinched({.upper_advances = {1, 0, 0, 0, 1}}));
    EXPECT_TRUE(is_pinched({.upper_advances = {0, 1, 1, 1, 0}}));
    EXPECT_FALSE(is_pinched({.upper_advances = {0, 1, 0, 1, 1}}));
    EXPECT_FALSE(is_pinched({.upper_advances = {1, 0, 1, 0}}));
}

TEST(PinchedBand, is_the_cheapest_of_contours_side_by_side_and_is_opened) {
    for (const std::size_t n : {5, 12, 30}) {
        const Points upper = circle_at(12, 0, 1), lower = circle_at(n, 9, 0);
        const SpanPath pinched = shortest_cycle({.upper = upper, .lower = lower});
        ASSERT_TRUE(is_pinched(pinched));
        const Band band = toroidal_band(upper, lower);
        EXPECT_FALSE(is_pinched(band.path));
        EXPECT_GE(band.path.cost, pinched.cost);
        const Problem p{.upper = upper, .lower = lower};
        EXPECT_NEAR(band.path.cost, cost_along(p, band.path), 1e-12 * band.path.cost);
        EXPECT_LE(band.path.cost,
                  toroidal_band(upper, lower, {.method = BandMethod::Greedy}).path.cost * (1 + 1e-12));
    }
}

TEST(PinchedBand, opened_is_often_the_cheapest_open_one_and_never_below_it) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> size(2, 5);
    int pinched_bands = 0, cheapest = 0;
    for (int run = 0; run < 600; ++run) {
        Problem p{.upper = grid_points(size(random), 5, random),
                  .lower = grid_points(size(random), 5, random)};
        for (Point3& point : p.lower) point.x += 12;
        const SpanContours contours{.upper = p.upper, .lower = p.lower};
        const SpanPath path = shortest_cycle(contours);
        if (!is_pinched(path)) continue;
        ++pinched_bands;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < p.upper.size(); ++i)
            for (std::uint32_t j = 0; j < p.lower.size(); ++j) {
                SpanPath start{.upper = i, .lower = j};
                least = std::min(least, least_open_cost(p, start, i, j, p.upper.size(), p.lower.size()));
            }
        const SpanPath open = opened(path, contours);
        EXPECT_FALSE(is_pinched(open));
        EXPECT_NEAR(open.cost, cost_along(p, open), 1e-11);
        EXPECT_GE(open.cost, least - 1e-11);
        if (open.cost <= least + 1e-11) ++cheapest;
    }
    EXPECT_GT(pinched_bands, 100);
    EXPECT_GT(cheapest, pinched_bands / 2);
}

}  // namespace
}  // namespace stratareeb
