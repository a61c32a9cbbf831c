// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/prediction_intervals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

namespace {

constexpr std::size_t kNearby = 8;  // errors that make the local ratio
constexpr double kPull = 4;         // errors of expected size that are added to them
constexpr double kLargestRatio = 1e6;
// Of n errors the next is the largest once in n + 1 times: 10 / n above the largest is as far as it goes.
constexpr double kBeyondLargest = 10;

//! Rank (0-based) of the conformal quantile among `count` scores; `count` if there are too few.
std::size_t conformal_rank(std::size_t count, double confidence) {
    const double rank = std::ceil((static_cast<double>(count) + 1) * confidence * (1 - 1e-12));
    return std::min(count, static_cast<std::size_t>(std::max(rank, 1.0)) - 1);
}

//! 0 / 0 is a right prediction amid right ones.
double score(double error, double scale) {
    return error == 0 ? 0 : std::abs(error) / scale;
}

double beyond_largest(std::size_t count) {
    return 1 + kBeyondLargest / static_cast<double>(count);
}

//! `by_size`: largest first.
double largest_of_others(const std::vector<PlacedError>& by_size, std::size_t draw) {
    for (const PlacedError& error : by_size)
        if (error.draw != draw) return std::abs(error.error);
    return 0;
}

}  // namespace

struct LocalError::Index {
    std::vector<Point2> places;
    NearestSites nearest;
    ErrorByGap by_gap;
    GapProfile all;
    std::map<std::size_t, GapProfile> without;  // by draw

    explicit Index(const std::vector<PlacedError>& errors)
        : places(places_of(errors)), nearest(places), by_gap(errors), all(by_gap.profile()) {
        for (const PlacedError& error : errors)
            if (!without.contains(error.draw)) without.emplace(error.draw, by_gap.without(error.draw));
    }
    static std::vector<Point2> places_of(const std::vector<PlacedError>& errors) {
        std::vector<Point2> places;
        for (const PlacedError& error : errors) places.push_back(error.at);
        return places;
    }
};

LocalError::LocalError(std::vector<PlacedError> errors)
    : errors_(std::move(errors)), index_(errors_.empty() ? nullptr : std::make_unique<Index>(errors_)) {}
LocalError::~LocalError() = default;
LocalError::LocalError(LocalError&&) noexcept = default;
LocalError& LocalError::operator=(LocalError&&) noexcept = default;

//! Without the errors of `draw`, where it is given.
double LocalError::sized(const GapProfile& profile, const Point2& place, double gap,
                         std::optional<std::size_t> draw) const {
    if (profile.gap.empty()) return 0;
    double ratios = 0;
    std::size_t found = 0;
    std::vector<NearSite> near;
    for (std::size_t asked = draw ? 2 * kNearby : kNearby;; asked *= 2) {
        index_->nearest.nearest(place, asked, near);
        ratios = 0, found = 0;
        for (const NearSite& site : near) {
            const PlacedError& error = errors_[site.site];
            if (error.draw == draw || found == kNearby) continue;
            const double expected = profile.at(error.gap);
            // Where errors so near to holes are all 0, so is this one, or the only other one of its class.
            ratios += expected > 0 ? std::min(std::abs(error.error) / expected, kLargestRatio) : 1;
            ++found;
        }
        if (found == kNearby || asked >= errors_.size()) break;
    }
    return profile.at(gap) * (ratios + kPull) / (static_cast<double>(found) + kPull);
}

double LocalError::at(const Point2& place, double gap) const {
    return index_ ? sized(index_->all, place, gap, std::nullopt) : 0;
}

double LocalError::at_without(const Point2& place, double gap, std::size_t draw) const {
    if (!index_) return 0;
    const auto profile = index_->without.find(draw);
    return sized(profile == index_->without.end() ? index_->all : profile->second, place, gap, draw);
}

bool has_enough_errors(std::size_t count, double confidence) {
    return conformal_rank(count, confidence) < count;
}

PredictionReach prediction_reach(const LocalError& local, double confidence) {
    std::vector<double> scores;
    double most = 0;
    for (const PlacedError& error : local.errors()) {
        most = std::max(most, std::abs(error.error));
        scores.push_back(score(error.error, local.at_without(error.at, error.gap, error.draw)));
    }
    if (scores.empty()) return {0, 0, false};
    std::ranges::sort(scores);
    const std::size_t rank = conformal_rank(scores.size(), confidence);
    return {scores[std::min(rank, scores.size() - 1)], most * beyond_largest(scores.size()),
            has_enough_errors(scores.size(), confidence)};
}

std::vector<double> held_out_half_widths(const LocalError& local, double confidence) {
    const auto errors = local.errors();
    std::vector<double> scale, scores;
    std::map<std::size_t, std::vector<std::size_t>> members;  // of a draw, later by rank
    for (std::size_t i = 0; i < errors.size(); ++i) {
        scale.push_back(local.at_without(errors[i].at, errors[i].gap, errors[i].draw));
        scores.push_back(score(errors[i].error, scale[i]));
    }
    std::vector<PlacedError> by_size(errors.begin(), errors.end());
    std::ranges::stable_sort(by_size, std::greater<>(),
                             [](const PlacedError& e) { return std::abs(e.error); });
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return scores[i]; });
    for (std::size_t rank = 0; rank < order.size(); ++rank) members[errors[order[rank]].draw].push_back(rank);

    std::map<std::size_t, PredictionReach> reach;
    for (const auto& [draw, own] : members) {
        const std::size_t others = errors.size() - own.size();
        if (others == 0) continue;
        std::size_t rank = std::min(conformal_rank(others, confidence), others - 1);
        for (const std::size_t taken : own) rank += taken <= rank;  // step over the draw's own scores
        reach[draw] = {scores[order[rank]], largest_of_others(by_size, draw) * beyond_largest(others)};
    }
    std::vector<double> widths;
    for (std::size_t i = 0; i < errors.size(); ++i)
        widths.push_back(reach[errors[i].draw].half_width(scale[i]));
    return widths;
}

}  // namespace stratareeb
