// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/inverse_distance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double rolling(const Point2& p) {
    return 10 + std::sin(7 * p.x) + std::cos(5 * p.y) * p.x;
}

std::vector<Point2> square_and(std::vector<Point2> at) {
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0}) at.push_back({x, y});
    return at;
}

TEST(InverseDistance, is_its_definition) {
    const auto at = square_and(places_over_square(1, 60)), where = places_over_square(2, 50);
    const auto value = values_at(at, rolling);
    for (const double power : {1.0, 2.0, 3.5})
        for (const std::size_t neighbours : {5, 12, 100}) {
            const auto found = predicted(InterpolatorKind::InverseDistance, at, value, where,
                                         {.power = power, .neighbours = neighbours});
            for (std::size_t k = 0; k < where.size(); ++k) {
                std::vector<std::pair<double, double>> near;
                for (std::size_t i = 0; i < at.size(); ++i)
                    near.emplace_back(std::hypot(at[i].x - where[k].x, at[i].y - where[k].y), value[i]);
                std::ranges::sort(near);
                double sum = 0, weights = 0;
                for (std::size_t i = 0; i < std::min(neighbours, near.size()); ++i) {
                    const double d = near[i].first;
                    const double R = neighbours < near.size() ? near[neighbours].first : 1e300;
                    const double w = std::pow(R > 1e299 ? 1 / d : (R - d) / (R * d), power);
                    sum += w * near[i].second, weights += w;
                }
                EXPECT_NEAR(found[k], sum / weights, 1e-10);
            }
        }
}

TEST(InverseDistance, keeps_within_the_values_and_does_not_jump) {
    const auto at = square_and(places_over_square(3, 80));
    const auto value = values_at(at, rolling);
    const auto [low, high] = std::ranges::minmax(value);
    std::vector<Point2> along;
    for (int i = 0; i <= 20'000; ++i) along.push_back({i / 20'000.0, 0.3 + 0.4 * i / 20'000.0});
    const auto z = predicted(InterpolatorKind::InverseDistance, at, value, along);
    for (std::size_t i = 0; i < z.size(); ++i) {
        EXPECT_GE(z[i], low);
        EXPECT_LE(z[i], high);
        EXPECT_NEAR(z[i], z[i == 0 ? 0 : i - 1], 4e-3);
    }
}

TEST(InverseDistance, takes_the_mean_of_equally_far_neighbours) {
    const auto z = predicted(InterpolatorKind::InverseDistance, {{0, 0}, {2, 0}, {0, 2}, {2, 2}},
                             {1, 2, 3, 6}, {{1, 1}}, {.neighbours = 2});
    EXPECT_GE(z[0], 1);
    EXPECT_LE(z[0], 6);
    EXPECT_NEAR(predicted(InterpolatorKind::InverseDistance, {{0, 0}, {2, 0}, {0, 2}, {2, 2}}, {1, 2, 3, 6},
                          {{1, 1}})[0],
                3, 1e-14);
}

TEST(InverseDistance, refuses_no_power_and_no_neighbours) {
    const auto holes = std::make_shared<HoleTriangulation>(places_over_square(1, 5));
    EXPECT_THROW(InverseDistance(holes, {.power = 0}), InvalidInput);
    EXPECT_THROW(InverseDistance(holes, {.neighbours = 0}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
