// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/closest_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::Random;

std::vector<Point2> random_points(Random& random, std::size_t n, bool on_grid) {
    std::vector<Point2> points(n);
    for (auto& p : points) {
        p = {random.uniform(0, 1), random.uniform(0, 1)};
        if (on_grid) p = {std::floor(p.x * 8), std::floor(p.y * 8)};
    }
    return points;
}

ClosestPair brute_force(const std::vector<Point2>& a, const std::vector<Point2>& b) {
    const auto key = [&](std::size_t i, std::size_t j) {
        const double x = a[i].x - b[j].x, y = a[i].y - b[j].y;
        return std::tuple(x * x + y * y, a[i].x, a[i].y, b[j].x, b[j].y, i, j);
    };
    auto best = key(0, 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) best = std::min(best, key(i, j));
    }
    return {std::get<5>(best), std::get<6>(best), std::sqrt(std::get<0>(best))};
}

TEST(ClosestPair, is_the_best_of_all_pairs_ties_included) {
    Random random(1);
    for (int round = 0; round < 3000; ++round) {
        const bool on_grid = round % 2 == 0;
        const auto a = random_points(random, 1 + random.below(60), on_grid);
        const auto b = random_points(random, 1 + random.below(60), on_grid);
        const auto found = closest_pair(a, b), expected = brute_force(a, b);
        EXPECT_EQ(found.first, expected.first);
        EXPECT_EQ(found.second, expected.second);
        EXPECT_DOUBLE_EQ(found.distance, expected.distance);
    }
}

TEST(ClosestPair, does_not_depend_on_numbering) {
    Random random(2);
    for (int round = 0; round < 300; ++round) {
        auto a = random_points(random, 30, false), b = random_points(random, 40, false);
        for (auto& p : a) p = {std::floor(p.x * 64) / 8, std::floor(p.y * 64) / 8};  // many equal distances
        for (auto& p : b) p = {std::floor(p.x * 64) / 8, std::floor(p.y * 64) / 8};
        const auto before = closest_pair(a, b);
        const Point2 p = a[before.first], q = b[before.second];
        std::rotate(a.begin(), a.begin() + 11, a.end());
        std::rotate(b.begin(), b.begin() + 23, b.end());
        const auto after = closest_pair(a, b);
        EXPECT_EQ(a[after.first], p);
        EXPECT_EQ(b[after.second], q);
    }
}

TEST(ClosestPair, copes_with_many_points_at_one_place_and_with_hundreds_of_thousands) {
    const std::vector<Point2> same(3000, Point2{0.5, 0.5});
    EXPECT_EQ(closest_pair(same, same).distance, 0);
    Random random(3);
    auto a = random_points(random, 200000, false), b = random_points(random, 200000, false);
    b[77777] = a[123456] = {0.25, 2};
    const auto found = closest_pair(a, b);
    EXPECT_EQ(found.first, 123456u);
    EXPECT_EQ(found.second, 77777u);
}

TEST(ClosestPair, parameters_are_compared_the_shorter_way_round) {
    Random random(4);
    for (int round = 0; round < 1000; ++round) {
        std::vector<double> a(1 + random.below(9)), b(1 + random.below(9));
        for (auto& s : a) s = random.uniform(0, 1);
        for (auto& s : b) s = random.uniform(0, 1);
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        double best = 1;
        for (const double s : a) {
            for (const double t : b) best = std::min({best, std::abs(s - t), 1 - std::abs(s - t)});
        }
        const auto found = closest_parameters(a, b);
        EXPECT_EQ(found.distance, best);
        const double straight = std::abs(a[found.first] - b[found.second]);
        EXPECT_EQ(std::min(straight, 1 - straight), best);
    }
}

}  // namespace
}  // namespace stratareeb
