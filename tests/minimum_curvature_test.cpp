// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/minimum_curvature.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double rolling(const Point2& p) {
    return 10 + std::sin(7 * p.x) + std::cos(5 * p.y) * p.x;
}

TEST(MinimumCurvature, reproduces_planes) {
    const auto at = places_over_square(1, 50), where = places_over_square(2, 100);
    const auto plane = [](const Point2& p) { return 3 - 2 * p.x + 5 * p.y; };
    const auto z = predicted(InterpolatorKind::MinimumCurvature, at, values_at(at, plane), where);
    const auto inside = std::make_shared<HoleTriangulation>(at)->locate(where);
    for (std::size_t k = 0; k < where.size(); ++k) {
        if (inside[k].inside) {
            EXPECT_NEAR(z[k], plane(where[k]), 1e-5);
        }
    }
}

// Both make ∫ z_xx² + 2 z_xy² + z_yy² least: over the whole plane the spline, over the sites' box the grid, which matters near the
// rim alone.
TEST(MinimumCurvature, is_the_thin_plate_spline_on_a_grid_away_from_the_rim) {
    const auto at = places_over_square(3, 150);
    const auto value = values_at(at, rolling);
    std::vector<Point2> where;
    for (const Point2& p : places_over_square(4, 200)) where.push_back({0.25 + 0.5 * p.x, 0.25 + 0.5 * p.y});
    const auto spline = predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0});
    double before = 0.02;
    for (const std::size_t nodes : {2500, 20'000}) {
        const auto grid =
            predicted(InterpolatorKind::MinimumCurvature, at, value, where, {.curvature_nodes = nodes});
        double sum = 0;
        for (std::size_t k = 0; k < where.size(); ++k) sum += (grid[k] - spline[k]) * (grid[k] - spline[k]);
        const double rms = std::sqrt(sum / static_cast<double>(where.size()));
        EXPECT_LT(rms, before) << nodes;
        before = rms;
    }
}

TEST(MinimumCurvature, with_tension_overshoots_less) {
    std::vector<Point2> at;
    std::vector<double> value;
    for (int i = 0; i < 11; ++i)
        for (int j = 0; j < 11; ++j) at.push_back({i / 10.0, j / 10.0}), value.push_back(i < 5 ? 0 : 1);
    const auto where = places_over_square(5, 500);
    const auto highest = [&](double tension) {
        return std::ranges::max(
            predicted(InterpolatorKind::MinimumCurvature, at, value, where, {.curvature_tension = tension}));
    };
    EXPECT_GT(highest(0), 1.05);
    EXPECT_LT(highest(0.9), 1 + (highest(0) - 1) / 2);
}

TEST(MinimumCurvature, refuses_tensions_out_of_range) {
    const auto holes = std::make_shared<HoleTriangulation>(places_over_square(1, 5));
    EXPECT_THROW(MinimumCurvature(holes, {.curvature_tension = 1}), InvalidInput);
    EXPECT_THROW(MinimumCurvature(holes, {.curvature_tension = -0.1}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
