// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/greedy_band.h"

#include <gtest/gtest.h>

#include "reeb/toroidal_graph.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

//! The rule, span by span: the shorter of the two next ones.
void expect_shorter_spans(const Problem& p, const SpanPath& path) {
    std::size_t i = path.upper, j = path.lower, up_left = p.rise(), low_left = p.run();
    ASSERT_EQ(path.upper_advances.size(), up_left + low_left);
    for (const bool up : path.upper_advances) {
        if (up_left > 0 && low_left > 0) {
            const double next_up = distance(p.u(i + 1), p.l(j)), next_low = distance(p.u(i), p.l(j + 1));
            if (next_up != next_low) {
                EXPECT_EQ(up, next_up < next_low);
            }
        }
        ++(up ? i : j);
        --(up ? up_left : low_left);
    }
    EXPECT_EQ(up_left + low_left, 0u);
}

TEST(GreedyBand, takes_the_shorter_span_and_knows_its_cost) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> size(2, 30);
    for (int run = 0; run < 300; ++run)
        for (const bool closed : {true, false}) {
            Problem p{.upper = wobbly_circle(size(random), 1, 1, 0.2, 0.1, random),
                      .lower = wobbly_circle(size(random), 1, 0, 0.2, 0.1, random),
                      .closed = closed};
            const SpanContours contours{.upper = p.upper, .lower = p.lower, .closed = closed};
            const SpanPath path = greedy_path(contours, 0, closed ? nearest_lower_point(contours, 0) : 0);
            ASSERT_NO_FATAL_FAILURE(expect_shorter_spans(p, path));
            EXPECT_NEAR(path.cost, cost_along(p, path), 1e-12 * path.cost);
        }
}

TEST(GreedyBand, is_never_cheaper_than_the_exact_one_from_any_first_span) {
    std::mt19937 random(2);
    for (int run = 0; run < 100; ++run) {
        const Points upper = wobbly_circle(20, 1, 0.5, 0.2, 0.1, random),
                     lower = wobbly_circle(15, 1, 0, 0.2, 0.1, random);
        for (const BandCost cost : {BandCost::Area, BandCost::SpanLength, BandCost::ParameterDistance}) {
            const double exact = toroidal_band(upper, lower, {.cost = cost}).path.cost;
            for (std::uint32_t i = 0; i < 20; ++i)
                for (std::uint32_t j = 0; j < 15; ++j) {
                    const BandOptions greedy{
                        .cost = cost, .method = BandMethod::Greedy, .first_span = std::array{i, j}};
                    EXPECT_GE(toroidal_band(upper, lower, greedy).path.cost, exact * (1 - 1e-12));
                }
        }
    }
}

TEST(GreedyBand, starts_at_the_nearest_lower_point) {
    const Points upper{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, lower{{5, 5, 0}, {0.1, 0, 0}, {-0.1, 0, 0}};
    EXPECT_EQ(nearest_lower_point({.upper = upper, .lower = lower}, 0), 1u);  // the first of equals
    EXPECT_EQ(toroidal_band(upper, lower, {.method = BandMethod::Greedy}).path.lower, 1u);
}

}  // namespace
}  // namespace stratareeb
