// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/choose_interpolator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"
#include "boreholes/thickness_field.h"

namespace stratareeb {

namespace {

constexpr std::size_t kFewestHoles = 5;
constexpr std::size_t kStays = static_cast<std::size_t>(-1);  // the fold of holes that are never held out

//! What holes say of one quantity.
struct Quantity {
    std::string name;
    bool thickness = true;
    std::vector<std::size_t> hole;
    std::vector<Point2> at;
    std::vector<double> value;
};

// Of holes at one place, the first that knows speaks.
std::vector<Quantity> quantities_of(const Survey& survey, const std::vector<std::size_t>& first_at_place) {
    std::vector<Quantity> result;
    const auto add = [&](std::string name, bool thickness, auto&& known) {
        Quantity q{std::move(name), thickness, {}, {}, {}};
        std::vector<char> spoken(survey.holes.size(), 0);
        for (std::size_t h = 0; h < survey.holes.size(); ++h) {
            const std::optional<double> value = known(survey.holes[h]);
            if (value && !std::exchange(spoken[first_at_place[h]], static_cast<char>(1)))
                q.hole.push_back(h), q.at.push_back(survey.holes[h].at), q.value.push_back(*value);
        }
        if (q.hole.size() >= kFewestHoles) result.push_back(std::move(q));
    };
    for (std::size_t i = 0; i <= survey.units.size(); ++i) {
        if (survey.contact_points) {
            add(i == 0 ? std::string("elevation of the ground")
                       : fmt::format("base of '{}'", survey.units[i - 1].code),
                false, [&](const Borehole& hole) {
                    return i < hole.horizons.size() ? hole.horizons[i] : std::nullopt;
                });
        } else if (i < survey.units.size()) {
            add(fmt::format("thickness of '{}'", survey.units[i].code), true, [&](const Borehole& hole) {
                const bool known = i < hole.layers.size() && hole.layers[i].knowledge == Knowledge::Measured;
                return known ? std::optional(hole.layers[i].thickness) : std::nullopt;
            });
        }
    }
    return result;
}

//! The first hole at each hole's place.
std::vector<std::size_t> first_at_place(const std::vector<Borehole>& holes) {
    std::vector<std::size_t> order(holes.size()), first(holes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t h) { return std::tuple(holes[h].at.x, holes[h].at.y, h); });
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] =
            k > 0 && holes[order[k - 1]].at == holes[order[k]].at ? first[order[k - 1]] : order[k];
    return first;
}

std::vector<std::size_t> folds_of(const std::vector<std::size_t>& first, const ChooseOptions& options) {
    std::vector<std::size_t> places;
    for (std::size_t h = 0; h < first.size(); ++h)
        if (first[h] == h) places.push_back(h);
    std::mt19937_64 random(options.seed);
    for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[random() % i]);
    std::vector<std::size_t> fold(first.size(), kStays);
    for (std::size_t k = 0; k < std::min(places.size(), options.most_holes); ++k)
        fold[places[k]] = k % options.folds;
    for (std::size_t h = 0; h < first.size(); ++h) fold[h] = fold[first[h]];
    return fold;
}

std::vector<double> predicted(const Quantity& q, const Quantity& rest,
                              const std::shared_ptr<HoleTriangulation>& holes, std::span<const Point2> where,
                              InterpolatorKind kind, const PinchOutRule& rule) {
    auto interpolator = make_interpolator(kind, holes);
    if (!q.thickness) return interpolator->predict(where, std::vector<SiteField>{{rest.value, {}}})[0];
    return ThicknessField(holes, {rest.value}, rule, std::move(interpolator)).predict(where)[0];
}

//! Sums of squared errors by candidate, and the number of holes that were held out.
std::size_t hold_out(const Quantity& q, const std::vector<std::size_t>& fold, const ChooseOptions& options,
                     std::vector<double>& squares) {
    std::size_t count = 0;
    for (std::size_t f = 0; f < options.folds; ++f) {
        Quantity rest, out;
        for (std::size_t k = 0; k < q.hole.size(); ++k) {
            Quantity& to = fold[q.hole[k]] == f ? out : rest;
            to.at.push_back(q.at[k]);
            to.value.push_back(q.value[k]);
        }
        if (out.at.empty() || rest.at.empty()) continue;
        const auto holes = std::make_shared<HoleTriangulation>(rest.at);
        count += out.at.size();
        for (std::size_t c = 0; c < squares.size(); ++c) {
            const auto z = predicted(q, rest, holes, out.at, options.candidates[c], options.pinch_out);
            for (std::size_t k = 0; k < z.size(); ++k)
                squares[c] += (z[k] - out.value[k]) * (z[k] - out.value[k]);
        }
    }
    return count;
}

//! Means of logarithms of errors against the first candidate's. Quantities that some candidate gets without an error tell nothing.
void set_ratios(std::vector<InterpolatorScore>& scores) {
    std::size_t told = 0;
    std::vector<double> logs(scores.size(), 0.0);
    for (std::size_t q = 0; q < scores[0].rmse.size(); ++q) {
        if (std::ranges::any_of(scores, [&](const auto& s) { return !(s.rmse[q] > 0); })) continue;
        ++told;
        for (std::size_t c = 0; c < scores.size(); ++c)
            logs[c] += std::log(scores[c].rmse[q] / scores[0].rmse[q]);
    }
    for (std::size_t c = 0; c < scores.size() && told > 0; ++c)
        scores[c].ratio = std::exp(logs[c] / static_cast<double>(told));
}

std::string reason_for(const InterpolatorChoice& choice, const InterpolatorScore& best,
                       const ChooseOptions& options) {
    const auto holes = choice.held_out.empty() ? 0 : std::ranges::max(choice.held_out);
    if (holes == 0) return fmt::format("{}: too few holes to compare methods on", name_of(choice.kind));
    std::string others;
    for (const InterpolatorScore& s : choice.scores)
        if (s.kind != best.kind)
            others += fmt::format("{}{} {:.2f}", others.empty() ? "" : ", ", name_of(s.kind), s.ratio);
    return fmt::format("{} has the least error at {} held-out holes in {} folds: {:.2f} of {}'s{}{}{}",
                       name_of(choice.kind), holes, options.folds, best.ratio,
                       name_of(options.candidates.front()), others.empty() ? "" : " (", others,
                       others.empty() ? "" : ")");
}

}  // namespace

InterpolatorChoice choose_interpolator(const Survey& survey, const ChooseOptions& options) {
    if (options.candidates.empty()) throw InvalidInput("there are no interpolators to choose from");
    if (options.folds < 2) throw InvalidInput("cross-validation needs at least two folds");
    InterpolatorChoice choice{options.candidates.front(), {}, {}, {}, {}};
    for (const InterpolatorKind kind : options.candidates) choice.scores.push_back({kind, {}, 1});
    const std::vector<std::size_t> first = first_at_place(survey.holes);
    const std::vector<std::size_t> fold = folds_of(first, options);
    for (const Quantity& q : quantities_of(survey, first)) {
        std::vector<double> squares(options.candidates.size(), 0.0);
        const std::size_t count = hold_out(q, fold, options, squares);
        if (count == 0) continue;
        choice.quantities.push_back(q.name);
        choice.held_out.push_back(count);
        for (std::size_t c = 0; c < squares.size(); ++c)
            choice.scores[c].rmse.push_back(std::sqrt(squares[c] / static_cast<double>(count)));
    }
    set_ratios(choice.scores);
    const auto best = std::ranges::min_element(choice.scores, {}, &InterpolatorScore::ratio);
    choice.kind = best->kind;
    choice.reason = reason_for(choice, *best, options);
    return choice;
}

}  // namespace stratareeb
