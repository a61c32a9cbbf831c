// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hold_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "boreholes/block_survey.h"
#include "boreholes/block_ties.h"
#include "boreholes/errors.h"
#include "boreholes/predict_columns.h"

namespace stratareeb {

namespace {

struct Rest {
    Survey survey;
    std::vector<std::size_t> hole;  // numbers in the whole survey
};

Rest without(const Survey& survey, const Draw& draw) {
    std::vector<char> out(survey.holes.size(), 0);
    for (const std::size_t h : draw) out.at(h) = 1;
    Rest rest{{survey.units, {}, survey.contact_points, survey.length_unit}, {}};
    for (std::size_t h = 0; h < survey.holes.size(); ++h)
        if (!out[h]) rest.survey.holes.push_back(survey.holes[h]), rest.hole.push_back(h);
    return rest;
}

//! Holes with these numbers, in survey coordinates, from others.
std::vector<HeldOutHole> predicted_from(const Survey& known, const Survey& survey, const Draw& holes,
                                        const HoldOutOptions& options) {
    const ColumnPredictor predictor(known, options.prediction, options.bare);
    std::vector<Point2> where;
    for (const std::size_t h : holes) where.push_back(survey.holes[h].at);
    const PredictedColumns columns = predictor.at(where);
    std::vector<HeldOutHole> result(holes.size());
    for (std::size_t d = 0; d < holes.size(); ++d) {
        result[d].hole = holes[d];
        result[d].inside = columns.inside[d];
        result[d].horizons.push_back(columns.ground[d]);
        for (const auto& layer : columns.thickness) {
            result[d].thickness.push_back(layer[d]);
            result[d].horizons.push_back(result[d].horizons.back() - layer[d]);
        }
    }
    return result;
}

//! The columns of ties that count for some blocks, predicted from the holes that are left.
std::vector<std::vector<Borehole>> ties_without(const Rest& rest, const std::map<std::uint32_t, Draw>& asked,
                                                const HoldOutOptions& options) {
    std::vector<BlockTie> ties;
    for (const BlockTie& tie : options.ties)
        if (std::ranges::any_of(tie.to, [&](std::uint32_t block) { return asked.contains(block); }))
            ties.push_back(tie);
    if (ties.empty()) return {};
    std::vector<std::uint32_t> block_of;
    for (const std::size_t h : rest.hole) block_of.push_back(options.block[h]);
    return tie_columns(rest.survey, block_of, ties, options.prediction, options.bare);
}

std::vector<HeldOutHole> predicted(const Survey& survey, const Draw& draw, const HoldOutOptions& options) {
    const Rest rest = without(survey, draw);
    if (options.block.empty()) return predicted_from(rest.survey, survey, draw, options);
    std::map<std::uint32_t, Draw> asked;
    std::map<std::size_t, HeldOutHole> found;
    for (const std::size_t h : draw) asked[options.block.at(h)].push_back(h);
    const auto ties = ties_without(rest, asked, options);
    for (const auto& [block, holes] : asked) {
        std::vector<std::uint32_t> own;
        for (std::uint32_t i = 0; i < rest.hole.size(); ++i)
            if (options.block[rest.hole[i]] == block) own.push_back(i);
        std::vector<std::string> notes;
        Survey known = survey_of_block(rest.survey, own, notes);
        if (block < ties.size())
            known.holes.insert(known.holes.end(), ties[block].begin(), ties[block].end());
        for (HeldOutHole& hole : predicted_from(known, survey, holes, options))
            found[hole.hole] = std::move(hole);
    }
    std::vector<HeldOutHole> result;
    for (const std::size_t h : draw) result.push_back(std::move(found.at(h)));
    return result;
}

//! Draws on all cores; which thread does which has no say in the result. Of several failures the first draw's is thrown.
void for_each_draw(std::size_t draws, const std::function<void(double)>& progress,
                   const std::function<void(std::size_t)>& work) {
    std::mutex lock;
    std::size_t next = 0, done = 0;
    std::map<std::size_t, std::exception_ptr> failures;
    const auto take = [&](std::size_t& draw) {
        const std::lock_guard guard(lock);
        draw = next;
        return failures.empty() && next++ < draws;
    };
    const auto run = [&] {
        for (std::size_t draw = 0; take(draw);) {
            std::exception_ptr failure;
            try {
                work(draw);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard guard(lock);
            if (failure) failures.emplace(draw, failure);
            if (progress) progress(static_cast<double>(++done) / static_cast<double>(draws));
        }
    };
    const std::size_t threads =
        std::min<std::size_t>(draws, std::max(1U, std::thread::hardware_concurrency()));
    {
        std::vector<std::jthread> others;
        for (std::size_t t = 1; t < threads; ++t) others.emplace_back(run);
        run();
    }
    if (!failures.empty()) std::rethrow_exception(failures.begin()->second);
}

Residual residual_of(std::span<const HeldOutHole> held, std::size_t i, std::size_t item, double actual,
                     double predicted) {
    return {i, held[i].hole, held[i].draw, item, actual, predicted, held[i].inside};
}

}  // namespace

std::vector<HeldOutHole> hold_out(const Survey& survey, const std::vector<Draw>& draws,
                                  const HoldOutOptions& options) {
    std::vector<std::vector<HeldOutHole>> of_draw(draws.size());
    for_each_draw(draws.size(), options.progress, [&](std::size_t d) {
        try {
            of_draw[d] = predicted(survey, draws[d], options);
        } catch (const InvalidInput& error) {
            throw InvalidInput(
                fmt::format("without the {} holes of draw {} of {}, the rest can't carry a prediction: {} "
                            "(leave out fewer at a time)",
                            draws[d].size(), d + 1, draws.size(), error.what()));
        }
    });
    std::vector<HeldOutHole> result;
    for (std::size_t d = 0; d < draws.size(); ++d)
        for (HeldOutHole& hole : of_draw[d]) {
            hole.draw = d;
            result.push_back(std::move(hole));
        }
    return result;
}

std::vector<Draw> without_last_contacts(const Survey& survey, std::vector<Draw> draws) {
    if (!survey.contact_points) return draws;
    std::vector<std::size_t> contacts(survey.units.size() + 1, 0);
    const auto for_each_known = [&](std::size_t hole, auto&& visit) {
        const auto& horizons = survey.holes[hole].horizons;
        for (std::size_t k = 0; k < horizons.size(); ++k)
            if (horizons[k]) visit(k);
    };
    for (std::size_t h = 0; h < survey.holes.size(); ++h)
        for_each_known(h, [&](std::size_t k) { ++contacts[k]; });
    for (Draw& draw : draws) {
        std::vector<std::size_t> left = contacts;
        std::erase_if(draw, [&](std::size_t hole) {
            bool needed = false;
            for_each_known(hole, [&](std::size_t k) { needed = needed || left[k] == 1; });
            if (!needed) for_each_known(hole, [&](std::size_t k) { --left[k]; });
            return needed;
        });
    }
    std::erase_if(draws, [](const Draw& draw) { return draw.empty(); });
    return draws;
}

std::vector<Draw> without_whole_blocks(std::span<const std::uint32_t> block, std::vector<Draw> draws) {
    std::map<std::uint32_t, std::size_t> holes_of;
    for (const std::uint32_t b : block) ++holes_of[b];
    for (Draw& draw : draws) {
        std::map<std::uint32_t, std::size_t> left = holes_of;
        if (block.empty()) break;
        for (const std::size_t h : draw) --left[block[h]];
        std::erase_if(draw, [&](std::size_t h) { return left[block[h]] == 0 && ++left[block[h]] == 1; });
    }
    std::erase_if(draws, [](const Draw& draw) { return draw.empty(); });
    return draws;
}

std::vector<Residual> thickness_residuals(const Survey& survey, std::span<const HeldOutHole> held,
                                          std::size_t layer) {
    std::vector<Residual> residuals;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const Borehole& hole = survey.holes[held[i].hole];
        if (layer < hole.layers.size() && hole.layers[layer].knowledge == Knowledge::Measured)
            residuals.push_back(
                residual_of(held, i, layer, hole.layers[layer].thickness, held[i].thickness[layer]));
    }
    return residuals;
}

std::vector<Residual> elevation_residuals(const Survey& survey, std::span<const HeldOutHole> held,
                                          std::size_t k) {
    std::vector<Residual> residuals;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const Borehole& hole = survey.holes[held[i].hole];
        if (k < hole.horizons.size() && hole.horizons[k])
            residuals.push_back(residual_of(held, i, k, *hole.horizons[k], held[i].horizons[k]));
    }
    return residuals;
}

BoundCheck check_bounds(const Survey& survey, std::span<const HeldOutHole> held, std::size_t layer) {
    BoundCheck check;
    for (const HeldOutHole& hole : held) {
        const auto& layers = survey.holes[hole.hole].layers;
        if (layer >= layers.size() || layers[layer].knowledge != Knowledge::AtLeast) continue;
        ++check.bounds;
        const double short_by = layers[layer].thickness - hole.thickness[layer];
        if (short_by <= 0) continue;
        ++check.below;
        check.shortfall += short_by;
    }
    return check;
}

std::size_t count_crossings(std::span<const HeldOutHole> held) {
    std::size_t crossings = 0;
    for (const HeldOutHole& hole : held)
        for (std::size_t k = 1; k < hole.horizons.size(); ++k)
            crossings += hole.horizons[k] > hole.horizons[k - 1];
    return crossings;
}

}  // namespace stratareeb
