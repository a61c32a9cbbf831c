// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/validation.h"

#include <cmath>

#include "boreholes/error_by_gap.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/placed_errors.h"
#include "boreholes/prediction_intervals.h"

namespace stratareeb {

namespace {

void add_tests(ItemValidation& item, const ValidationOptions& options) {
    std::vector<double> errors, inside, actual, predicted;
    for (const Residual& residual : item.residuals) {
        errors.push_back(residual.error());
        if (residual.inside) inside.push_back(residual.error());
        actual.push_back(residual.actual);
        predicted.push_back(residual.predicted);
    }
    item.errors = summarize_errors(errors);
    item.inside = summarize_errors(inside);
    item.z = z_test(actual, predicted);
    item.z_p = two_sided_p(MeanLaw::Normal, item.z.z, 0);
    item.bias = mean_test(errors, options.confidence, options.law);
}

void add_intervals(ItemValidation& item, const LocalError& local, const ValidationOptions& options) {
    item.half_width = held_out_half_widths(local, options.confidence);
    item.certain = has_enough_errors(item.residuals.size(), options.confidence);
    for (std::size_t i = 0; i < item.half_width.size(); ++i) {
        item.covered += std::abs(item.residuals[i].error()) <= item.half_width[i];
        item.mean_half_width += item.half_width[i] / static_cast<double>(item.half_width.size());
    }
}

ItemValidation item_of(std::string name, std::vector<Residual> residuals, const LocalError& local,
                       const ValidationOptions& options) {
    ItemValidation item;
    item.name = std::move(name);
    item.residuals = std::move(residuals);
    add_tests(item, options);
    add_intervals(item, local, options);
    return item;
}

//! Errors of all quantities, in the order of layers or horizons.
using LocalErrors = std::vector<LocalError>;

LocalErrors add_layers(Validation& result, const Survey& survey, const ValidationOptions& options) {
    LocalErrors errors;
    if (survey.contact_points) return errors;
    for (std::size_t i = 0; i < survey.units.size(); ++i) {
        auto residuals = thickness_residuals(survey, result.held, i);
        const KnowingHoles know = knowing_holes(
            survey, result.draws, [i](const Borehole& hole) { return knows_thickness(hole, i); });
        errors.emplace_back(placed_errors(survey, residuals, know));
        auto& item = result.layers.emplace_back(
            item_of(survey.units[i].name, std::move(residuals), errors.back(), options));
        item.bounds = check_bounds(survey, result.held, i);
        for (const Residual& residual : item.residuals)
            item.presence_right += (residual.actual > 0) == (residual.predicted > 0);
    }
    return errors;
}

LocalErrors add_horizons(Validation& result, const Survey& survey, const ValidationOptions& options) {
    LocalErrors errors;
    for (std::size_t k = 0; k <= survey.units.size(); ++k) {
        auto residuals = elevation_residuals(survey, result.held, k);
        const KnowingHoles know =
            knowing_holes(survey, result.draws, [k](const Borehole& hole) { return knows_horizon(hole, k); });
        errors.emplace_back(placed_errors(survey, residuals, know));
        result.horizons.push_back(item_of(k == 0 ? "ground" : "base of " + survey.units[k - 1].name,
                                          std::move(residuals), errors.back(), options));
    }
    return errors;
}

void pool(Validation& result, const ValidationOptions& options) {
    std::vector<double> errors;
    std::vector<std::size_t> hole;
    for (const ItemValidation& item : result.layers.empty() ? result.horizons : result.layers)
        for (const Residual& residual : item.residuals) {
            errors.push_back(residual.error());
            hole.push_back(residual.hole);
        }
    result.pooled = grouped_mean_test(errors, hole, options.confidence, options.law);
    result.pooled_naive = mean_test(errors, options.confidence, options.law);
    std::size_t covered = 0, intervals = 0;
    for (const auto* items : {&result.layers, &result.horizons})
        for (const ItemValidation& item : *items) {
            covered += item.covered;
            intervals += item.errors.count;
        }
    result.coverage = intervals == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(intervals);
}

//! By the errors of all layers together; of contact points, of all horizons.
void suggest(Validation& result, const Survey& survey, const LocalErrors& errors, std::size_t count) {
    std::vector<Point2> holes;
    for (const Borehole& hole : survey.holes) holes.push_back(hole.at);
    const NearestSites nearest(holes);
    result.next = next_boreholes(holes, count, [&](const Point2& place) {
        const double gap = std::sqrt(nearest.nearest(place, 1).front().squared_distance);
        double error = 0;
        for (const LocalError& item : errors) error += item.at(place, gap);
        return error;
    });
}

}  // namespace

Validation validate(const Survey& survey, const std::vector<Draw>& draws, const ValidationOptions& options) {
    Validation result;
    result.draws = without_whole_blocks(options.hold_out.block, without_last_contacts(survey, draws));
    result.held = hold_out(survey, result.draws, options.hold_out);
    const LocalErrors of_layers = add_layers(result, survey, options);
    const LocalErrors of_horizons = add_horizons(result, survey, options);
    pool(result, options);
    result.units = match_units(survey, result.held);
    result.crossings = count_crossings(result.held);
    suggest(result, survey, survey.contact_points ? of_horizons : of_layers, options.suggestions);
    return result;
}

}  // namespace stratareeb
