// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/choose_interpolator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

#include "boreholes/error_statistics.h"
#include "boreholes/errors.h"
#include "boreholes/hold_out.h"

namespace stratareeb {

namespace {

constexpr std::size_t kFewestHoles = 5;

//! Numbers of holes, of those at one place the first.
std::vector<std::size_t> single_places(const Survey& survey) {
    const auto& holes = survey.holes;
    std::vector<std::size_t> order(holes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t h) { return std::tuple(holes[h].at.x, holes[h].at.y, h); });
    const auto repeated = std::ranges::unique(
        order, {}, [&](std::size_t h) { return std::pair(holes[h].at.x, holes[h].at.y); });
    order.erase(repeated.begin(), repeated.end());
    std::ranges::sort(order);
    return order;
}

Survey part_of(const Survey& survey, const std::vector<std::size_t>& holes) {
    Survey result{survey.units, {}, survey.contact_points, survey.length_unit};
    for (const std::size_t h : holes) result.holes.push_back(survey.holes[h]);
    return result;
}

std::vector<std::uint32_t> part_of(const std::vector<std::uint32_t>& block,
                                   const std::vector<std::size_t>& holes) {
    std::vector<std::uint32_t> result;
    for (const std::size_t h : holes)
        if (!block.empty()) result.push_back(block[h]);
    return result;
}

//! Most holes are in no draw where there are many.
std::vector<Draw> draws_of(std::size_t holes, const ChooseOptions& options) {
    std::vector<std::size_t> order(holes);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 random(options.seed);
    for (std::size_t i = holes; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    std::vector<Draw> draws(std::min(options.folds, holes));
    for (std::size_t k = 0; k < std::min(holes, options.most_holes); ++k)
        draws[k % options.folds].push_back(order[k]);
    for (Draw& draw : draws) std::ranges::sort(draw);
    std::erase_if(draws, [](const Draw& draw) { return draw.empty(); });
    return draws;
}

//! What is compared: the thickness of each layer and the elevation of each base; of contact points, all elevations.
struct Quantity {
    std::string name;
    bool thickness;
    std::size_t number;
};

std::vector<Quantity> quantities_of(const Survey& survey) {
    std::vector<Quantity> result;
    if (survey.contact_points) result.push_back({"elevation of the ground", false, 0});
    for (std::size_t i = 0; i < survey.units.size() && !survey.contact_points; ++i)
        result.push_back({fmt::format("thickness of '{}'", survey.units[i].code), true, i});
    for (std::size_t i = 0; i < survey.units.size(); ++i)
        result.push_back({fmt::format("base of '{}'", survey.units[i].code), false, i + 1});
    return result;
}

std::vector<double> errors_of(const Survey& survey, const std::vector<HeldOutHole>& held, const Quantity& q) {
    std::vector<double> errors;
    for (const Residual& residual : q.thickness ? thickness_residuals(survey, held, q.number)
                                                : elevation_residuals(survey, held, q.number))
        errors.push_back(residual.error());
    return errors;
}

//! Predictions of all candidates for all draws.
std::vector<std::vector<HeldOutHole>> held_out(const Survey& survey, const std::vector<Draw>& draws,
                                               const ChooseOptions& options) {
    std::vector<std::vector<HeldOutHole>> result;
    for (const InterpolatorKind kind : options.candidates) {
        HoldOutOptions hold;
        hold.bare = options.bare;
        hold.prediction.interpolator = kind;
        hold.prediction.pinch_out = options.pinch_out;
        hold.prediction.terrain = options.terrain;
        hold.prediction.rules = options.rules;
        hold.block = options.block;
        hold.ties = options.ties;
        const auto done = static_cast<double>(result.size());
        if (options.progress)
            hold.progress = [&options, done](double share) {
                options.progress((done + share) / static_cast<double>(options.candidates.size()));
            };
        result.push_back(hold_out(survey, draws, hold));
    }
    return result;
}

void score(InterpolatorChoice& choice, const Survey& survey, const ChooseOptions& options) {
    const std::vector<Draw> draws = without_whole_blocks(
        options.block, without_last_contacts(survey, draws_of(survey.holes.size(), options)));
    const auto held = held_out(survey, draws, options);
    for (const Quantity& q : quantities_of(survey)) {
        if (errors_of(survey, held[0], q).size() < kFewestHoles) continue;
        choice.quantities.push_back(q.name);
        for (std::size_t c = 0; c < held.size(); ++c) {
            const ErrorSummary errors = summarize_errors(errors_of(survey, held[c], q));
            if (c == 0) choice.held_out.push_back(errors.count);
            choice.scores[c].rmse.push_back(errors.rmse);
        }
    }
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
    const std::vector<std::size_t> holes = single_places(survey);
    const Survey single = part_of(survey, holes);
    ChooseOptions of_single = options;
    of_single.block = part_of(options.block, holes);
    if (single.holes.size() >= kFewestHoles) {
        try {
            score(choice, single, of_single);
        } catch (const InvalidInput&) {
            // The rest of some draw says too little; whether all holes say enough is for the caller to find.
            choice.quantities.clear(), choice.held_out.clear();
            for (InterpolatorScore& s : choice.scores) s.rmse.clear();
        }
    }
    set_ratios(choice.scores);
    const auto best = std::ranges::min_element(choice.scores, {}, &InterpolatorScore::ratio);
    choice.kind = best->kind;
    choice.reason = reason_for(choice, *best, options);
    return choice;
}

}  // namespace stratareeb
