// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/patch_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boreholes/field_sites.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

std::vector<Point2> clustered(std::uint64_t seed, std::size_t count) {
    auto at = places_over_square(seed, count);
    for (std::size_t i = 0; i < count; i += 2) at[i] = {0.3 + 0.001 * at[i].x, 0.6 + 0.002 * at[i].y};
    return at;
}

TEST(NearestSites, are_those_that_a_search_of_all_finds) {
    auto at = clustered(1, 500);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) at.push_back({i / 8.0, j / 8.0});  // with equal distances
    const NearestSites index(at);
    for (const Point2& p : places_over_square(2, 100)) {
        const Point2 q{std::round(p.x * 16) / 16, std::round(p.y * 16) / 16};
        std::vector<NearSite> all;
        for (std::uint32_t i = 0; i < at.size(); ++i) {
            const double dx = at[i].x - q.x, dy = at[i].y - q.y;
            all.push_back({dx * dx + dy * dy, i});
        }
        std::ranges::sort(all);
        all.resize(17);
        EXPECT_EQ(index.nearest(q, 17), all);
        const PlanBox box{{p.x - 0.1, p.y - 0.02}, {p.x + 0.05, p.y + 0.2}};
        std::vector<std::uint32_t> inside;
        for (std::uint32_t i = 0; i < at.size(); ++i)
            if (box.contains(at[i])) inside.push_back(i);
        EXPECT_EQ(index.in_box(box), inside);
        EXPECT_EQ(index.has_more_in(box, 10), inside.size() > 10);
    }
    EXPECT_EQ(index.nearest({0, 0}, 10'000).size(), at.size());
    EXPECT_TRUE(NearestSites({}).nearest({0, 0}, 3).empty());
}

TEST(PatchCover, shares_each_place_out_and_knows_its_sites) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto at = clustered(seed, 3000);
        const PatchCover cover(at, {.single = 100, .largest = 60, .fewest = 30});
        ASSERT_GT(cover.size(), 50u);
        std::vector<std::vector<std::uint32_t>> sites;
        for (std::uint32_t k = 0; k < cover.size(); ++k) {
            sites.push_back(cover.sites(k));
            EXPECT_GE(sites[k].size(), 30u);
            EXPECT_LE(sites[k].size(), 90u);
        }
        std::vector<PatchWeight> weights;
        for (std::uint32_t i = 0; i < at.size(); ++i) {
            cover.weights(at[i], weights);
            double sum = 0;
            for (const auto& [patch, weight] : weights) {
                sum += weight;
                EXPECT_TRUE(std::ranges::binary_search(sites[patch], i))
                    << "a patch with a say knows the site";
            }
            EXPECT_NEAR(sum, 1, 1e-14);
        }
    }
}

TEST(PatchCover, has_weights_without_jumps_or_creases) {
    const auto at = clustered(7, 2000);
    const PatchCover cover(at, {.single = 100, .largest = 60, .fewest = 30});
    std::vector<PatchWeight> weights;
    const auto weight_of = [&](std::uint32_t patch, const Point2& p) {
        cover.weights(p, weights);
        for (const auto& w : weights)
            if (w.patch == patch) return w.weight;
        return 0.0;
    };
    // The second difference over the square of the step is bounded by a second derivative.
    const auto bend = [&](double h) {
        double largest = 0;
        for (int i = 1; i < 4000; ++i) {
            const double x = 0.05 + 0.9 * i / 4000, y = 0.8;
            largest = std::max(largest, std::abs(weight_of(3, {x - h, y}) - 2 * weight_of(3, {x, y}) +
                                                 weight_of(3, {x + h, y})) /
                                            (h * h));
        }
        return largest;
    };
    EXPECT_LT(bend(1e-5), 2 * bend(1e-3) + 1);
}

TEST(PatchCover, of_few_sites_or_a_crowd_is_still_one) {
    const std::vector<Point2> one{{3, 3}};
    EXPECT_EQ(PatchCover(one).size(), 1u);
    std::vector<Point2> crowd(2000);
    for (std::size_t i = 0; i < crowd.size(); ++i) crowd[i] = {1 + 1e-15 * static_cast<double>(i % 2), 1};
    crowd.push_back({0, 0});
    const PatchCover cover(crowd, {.single = 10, .largest = 50, .fewest = 20});
    for (std::uint32_t k = 0; k < cover.size(); ++k) EXPECT_LE(cover.sites(k).size(), 200u);
}

TEST(FieldSites, have_each_place_once_near_zero) {
    const std::vector<Point2> at{
        {5e6, 4e6}, {5e6 + 100, 4e6}, {5e6, 4e6}, {5e6 + 100, 4e6}, {5e6 + 3, 4e6 + 7}};
    const std::vector<double> value{1, 2, 3, 4, 5};
    const std::vector<char> use{1, 1, 1, 1, 0}, at_least{0, 1, 0, 0, 0};
    const FieldSites sites = field_sites(at, {value, use, at_least});
    EXPECT_EQ(sites.site, (std::vector<std::uint32_t>{0, 3}))
        << "the first, and a measured value before a bound";
    EXPECT_EQ(sites.measured, 2u);
    for (const Point2& p : sites.at) EXPECT_LE(std::hypot(p.x, p.y), 2);
    EXPECT_EQ(sites.at[1].x - sites.at[0].x, 100 * sites.frame.xx);
    const SiteLookup lookup(at, sites);
    ASSERT_NE(lookup.value_at({5e6 + 100, 4e6}), nullptr);
    EXPECT_EQ(*lookup.value_at({5e6 + 100, 4e6}), 4);
    EXPECT_EQ(lookup.value_at({5e6 + 3, 4e6 + 7}), nullptr);
    EXPECT_EQ(field_sites({}, {}).size(), 0u);
}

}  // namespace
}  // namespace stratareeb
