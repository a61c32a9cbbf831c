// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/step_bounds.h"

#include <gtest/gtest.h>

#include "reeb/greedy_band.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

//! What the step costs at least, by trying all.
double least_step(const Problem& p, bool upper, std::size_t i) {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t others = upper ? p.lower.size() : p.upper.size();
    for (std::size_t j = 0; j < others; ++j) least = std::min(least, upper ? p.up(i, j) : p.low(j, i));
    return least;
}

void expect_bounds(const Problem& p, double tolerance) {
    const SpanContours contours{.upper = p.upper, .lower = p.lower, .cost = p.cost};
    const std::uint32_t i0 = 3, j0 = 2;
    const StepBounds bounds = step_bounds(contours, i0, j0, greedy_path(contours, 0, 0));
    ASSERT_EQ(bounds.upper.size(), 2 * p.upper.size() + 1);
    ASSERT_EQ(bounds.lower.size(), p.lower.size() + 1);
    for (std::size_t i = 1; i < bounds.upper.size(); ++i) {
        const double bound = bounds.upper[i] - bounds.upper[i - 1], least = least_step(p, true, i0 + i - 1);
        EXPECT_LE(bound, least + 1e-11);
        EXPECT_GE(bound, least * (1 - tolerance) - 1e-11);
    }
    for (std::size_t j = 1; j < bounds.lower.size(); ++j) {
        const double bound = bounds.lower[j] - bounds.lower[j - 1], least = least_step(p, false, j0 + j - 1);
        EXPECT_LE(bound, least + 1e-11);
        EXPECT_GE(bound, least * (1 - tolerance) - 1e-11);
    }
}

TEST(StepBounds, are_below_every_step_of_an_edge_and_near_the_least) {
    std::mt19937 random(1);
    for (int run = 0; run < 100; ++run)
        for (const BandCost cost : {BandCost::Area, BandCost::SpanLength}) {
            expect_bounds({.upper = grid_points(5 + run % 40, 4, random),
                           .lower = grid_points(30, 4, random),
                           .cost = cost},
                          0.03);
            expect_bounds({.upper = wobbly_circle(60, 1, 0.3, 0.2, 0.05 * (run % 2), random),
                           .lower = wobbly_circle(5 + static_cast<std::size_t>(run), 1, 0, 0.2, 0, random),
                           .cost = cost},
                          0.03);
        }
}

}  // namespace
}  // namespace stratareeb
