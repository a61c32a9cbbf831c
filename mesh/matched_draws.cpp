// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/matched_draws.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/error_by_gap.h"

namespace stratareeb {

namespace {

constexpr std::size_t kFewestGroups = 4;

double squared_distance(const Point2& a, const Point2& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

//! The group of each hole: that of the nearest of `count` centres, each the hole farthest from those before it.
std::vector<std::size_t> groups_of(std::span<const Point2> holes, std::size_t count) {
    std::vector<std::size_t> group(holes.size(), 0);
    std::vector<double> far(holes.size(), HUGE_VAL);
    std::size_t centre = 0;
    for (std::size_t g = 0; g < count; ++g) {
        for (std::size_t h = 0; h < holes.size(); ++h) {
            const double distance = squared_distance(holes[h], holes[centre]);
            if (distance < far[h]) far[h] = distance, group[h] = g;
        }
        centre = static_cast<std::size_t>(std::ranges::max_element(far) - far.begin());
    }
    return group;
}

//! Groups dealt out to as many draws, the largest first to the draw with the fewest holes.
std::vector<Draw> draws_of_groups(const std::vector<std::size_t>& group, std::size_t count,
                                  std::size_t folds) {
    std::vector<Draw> members(count);
    for (std::size_t h = 0; h < group.size(); ++h) members[group[h]].push_back(h);
    std::ranges::stable_sort(members, std::greater<>(), &Draw::size);
    std::vector<Draw> draws(folds);
    for (const Draw& holes : members) {
        Draw& fewest = *std::ranges::min_element(draws, {}, &Draw::size);
        fewest.insert(fewest.end(), holes.begin(), holes.end());
    }
    std::erase_if(draws, [](const Draw& draw) { return draw.empty(); });
    for (Draw& draw : draws) std::ranges::sort(draw);
    return draws;
}

//! Mean distance between two distributions, at their percentiles (Wasserstein's).
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    constexpr int kShares = 100;
    double sum = 0;
    for (int i = 0; i < kShares; ++i) {
        const auto at = [&](const std::vector<double>& sorted) {
            return sorted[static_cast<std::size_t>((i + 0.5) / kShares * static_cast<double>(sorted.size()))];
        };
        sum += std::abs(at(a) - at(b)) / kShares;
    }
    return sum;
}

std::vector<double> gaps_of(std::span<const Point2> holes, const std::vector<Draw>& draws) {
    std::vector<std::size_t> draw_of(holes.size()), all(holes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (std::size_t d = 0; d < draws.size(); ++d)
        for (const std::size_t h : draws[d]) draw_of[h] = d;
    std::vector<double> gaps = gaps_to_other_draws(holes, draw_of, all);
    std::ranges::sort(gaps);
    return gaps;
}

}  // namespace

MatchedDraws matched_draws(std::span<const Point2> holes, std::vector<double> asked, std::size_t folds,
                           std::uint64_t seed) {
    MatchedDraws best{fold_draws(holes.size(), folds, seed), std::vector<std::size_t>(holes.size())};
    std::iota(best.group.begin(), best.group.end(), std::size_t{0});
    if (asked.empty()) return best;
    std::ranges::sort(asked);
    double least = difference(asked, gaps_of(holes, best.draws));
    for (std::size_t count = holes.size() / 2; count >= kFewestGroups; count = count * 3 / 4) {
        std::vector<std::size_t> group = groups_of(holes, count);
        std::vector<Draw> draws = draws_of_groups(group, count, std::min(folds, count));
        const std::size_t largest = std::ranges::max(draws, {}, &Draw::size).size();
        if (draws.size() < 2 || 2 * largest > holes.size())
            continue;  // too few would be left to predict from
        const double off = difference(asked, gaps_of(holes, draws));
        if (off < least) least = off, best = {std::move(draws), std::move(group)};
    }
    return best;
}

}  // namespace stratareeb
