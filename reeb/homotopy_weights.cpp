// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/homotopy_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr double kNegligible = 1e-18;  // no coordinate has that many digits
constexpr std::array<std::string_view, 6> kNames{"linear",   "parabola",    "quadrant",
                                                 "cardinal", "catmull-rom", "natural-cubic"};

void check_places(const std::vector<double>& places) {
    if (places.size() < 2) {
        throw InvalidInput(fmt::format("homotopy: {} contours (expected at least two)", places.size()));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!std::isfinite(places[i]) || (i > 0 && !(places[i] > places[i - 1]))) {
            throw InvalidInput(fmt::format(
                "homotopy: contour {} is at {} (expected each above the one before)", i, places[i]));
        }
    }
}

//! What is left of the starting contour after share t of the way.
double share_of_start(HomotopyKind kind, double t) {
    if (kind == HomotopyKind::Linear) return 1 - t;
    return kind == HomotopyKind::Parabola ? (1 - t) * (1 + t) : std::sqrt((1 - t) * (1 + t));
}

}  // namespace

std::string_view homotopy_name(HomotopyKind kind) {
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<HomotopyKind> homotopy_kind(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<HomotopyKind>(found - kNames.begin());
}

HomotopyWeights::HomotopyWeights(std::vector<double> places, const HomotopyOptions& options)
    : places_(std::move(places)), options_(options) {
    check_places(places_);
    if (!std::isfinite(options.tension) || !std::isfinite(options.a) || !std::isfinite(options.b)) {
        throw InvalidInput("homotopy: tension, a and b must be finite numbers");
    }
    for (std::size_t i = 1; i < intervals(); ++i) {
        const double diagonal = 2 * (step(i - 1) + step(i));
        pivots_.push_back(i == 1 ? diagonal : diagonal - step(i - 1) * step(i - 1) / pivots_.back());
    }
}

std::vector<ContourWeight> HomotopyWeights::at(std::size_t interval, double t) const {
    if (t <= 0) return {{interval, 1}};
    if (t >= 1) return {{interval + 1, 1}};
    if (options_.kind == HomotopyKind::NaturalCubic) return of_all(interval, t);
    return options_.kind <= HomotopyKind::Quadrant ? of_two(interval, t) : of_four(interval, t);
}

std::vector<ContourWeight> HomotopyWeights::of_two(std::size_t interval, double t) const {
    if (options_.direction == HomotopyDirection::Upward) {
        const double start = share_of_start(options_.kind, t);
        return {{interval, start}, {interval + 1, 1 - start}};
    }
    const double start = share_of_start(options_.kind, 1 - t);
    return {{interval, 1 - start}, {interval + 1, start}};
}

//! The slope at a contour of the parabola through it and its neighbours, or through the three at the end; of two, of the line.
std::vector<ContourWeight> HomotopyWeights::parabola_slope(std::size_t contour) const {
    if (intervals() == 1) return {{0, -1 / step(0)}, {1, 1 / step(0)}};
    const std::size_t i = std::clamp<std::size_t>(contour, 1, intervals() - 1);  // in the middle of the three
    const double below = step(i - 1), above = step(i), both = below + above;
    const double x = places_[contour] - places_[i];  // Lagrange's polynomials, differentiated there
    return {{i - 1, (2 * x - above) / (below * both)},
            {i, (above - below - 2 * x) / (below * above)},
            {i + 1, (2 * x + below) / (above * both)}};
}

std::vector<ContourWeight> HomotopyWeights::of_four(std::size_t interval, double t) const {
    const std::size_t first = interval == 0 ? 0 : interval - 1, last = std::min(interval + 2, intervals());
    std::vector<ContourWeight> weights;
    for (std::size_t i = first; i <= last; ++i) weights.push_back({i, 0});
    const double h = step(interval);
    // `share` of the slope from contour i to contour j; a mirrored contour has the slope of the interval it mirrors.
    const auto add_slope = [&](double share, std::size_t i, std::size_t j) {
        const double part = share * h / (places_[j] - places_[i]);
        weights[i - first].weight -= part;
        weights[j - first].weight += part;
    };
    const double from_start = t * (1 - t) * (1 - t), from_end = -t * t * (1 - t);  // Hermite's, of the slopes
    const auto add_parabola_slope = [&](double share, std::size_t contour) {
        for (const auto& [i, weight] : parabola_slope(contour))
            weights[i - first].weight += share * h * weight;
    };
    if (options_.kind == HomotopyKind::Cardinal && options_.pace == HomotopyPace::Round) {
        add_parabola_slope(2 * options_.tension * from_start, interval);
        add_parabola_slope(2 * options_.tension * from_end, interval + 1);
    } else if (options_.kind == HomotopyKind::Cardinal) {
        add_slope(2 * options_.tension * from_start, first, interval + 1);
        add_slope(2 * options_.tension * from_end, interval, last);
    } else {
        add_slope((1 - options_.a) * from_start, first, std::max(interval, first + 1));
        add_slope(options_.a * from_start, interval, interval + 1);
        add_slope((1 - options_.b) * from_end, interval, interval + 1);
        add_slope(options_.b * from_end, std::min(interval + 1, last - 1), last);
    }
    const double of_end = t * t * (3 - 2 * t);
    weights[interval - first].weight += 1 - of_end;
    weights[interval + 1 - first].weight += of_end;
    return weights;
}

//! The spline is A y_k + B y_{k+1} + C M_k + D M_{k+1} with second derivatives M = T^-1 R y. T is symmetric, so the weights of
//! y are A, B and R^T (T^-1 (C, D)): one tridiagonal solve for a place, however many points the contours have.
std::vector<ContourWeight> HomotopyWeights::of_all(std::size_t interval, double t) const {
    const std::size_t inner = intervals() - 1;
    const double h = step(interval), s = 1 - t;
    std::vector<double> right_side(inner, 0.0);
    if (interval > 0) right_side[interval - 1] = -s * (1 - s * s) * h * h / 6;
    if (interval < inner) right_side[interval] = -t * (1 - t * t) * h * h / 6;
    const auto u = solved(std::move(right_side));
    std::vector<double> weights(places_.size(), 0.0);
    weights[interval] = s;
    weights[interval + 1] = t;
    for (std::size_t i = 1; i <= inner; ++i) {
        const double below = 6 * u[i - 1] / step(i - 1), above = 6 * u[i - 1] / step(i);
        weights[i - 1] += below;
        weights[i] -= below + above;
        weights[i + 1] += above;
    }
    std::vector<ContourWeight> result;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (std::abs(weights[i]) > kNegligible || i == interval) result.push_back({i, weights[i]});
    }
    return result;
}

std::vector<double> HomotopyWeights::solved(std::vector<double> x) const {
    for (std::size_t i = 1; i < x.size(); ++i) x[i] -= step(i) / pivots_[i - 1] * x[i - 1];
    for (std::size_t i = x.size(); i-- > 0;) {
        const double above = i + 1 < x.size() ? step(i + 1) * x[i + 1] : 0;
        x[i] = (x[i] - above) / pivots_[i];
    }
    return x;
}

}  // namespace stratareeb
