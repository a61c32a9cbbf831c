// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/error_spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "boreholes/error_by_gap.h"
#include "boreholes/errors.h"
#include "boreholes/hold_out.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/placed_errors.h"
#include "boreholes/prediction_intervals.h"
#include "mesh/matched_draws.h"
#include "mesh/plan_gaps.h"

namespace stratareeb {

namespace {

constexpr std::size_t kFewestErrors = 5;
// A deviation is no larger than the 95 % interval of normal errors makes it: a few wild ones don't speak for all.
constexpr double kUsualConfidence = 0.95, kDeviationsOfUsual = 1.96;

bool knows(const Borehole& hole, const PredictedQuantity& quantity) {
    return quantity.thickness ? knows_thickness(hole, quantity.index) : knows_horizon(hole, quantity.index);
}

std::vector<PlacedError> placed_errors(const Survey& survey, const std::vector<Draw>& draws,
                                       const KnowingHoles& know, const PredictedQuantity& quantity,
                                       const CompletionOptions& prediction) {
    const auto held = hold_out(survey, draws, {.prediction = prediction});
    return placed_errors(survey,
                         quantity.thickness ? thickness_residuals(survey, held, quantity.index)
                                            : elevation_residuals(survey, held, quantity.index),
                         know);
}

//! Root mean square of errors over what others say of their size.
double deviation_over_size(const LocalError& local) {
    double squares = 0, count = 0;
    for (const PlacedError& error : local.errors()) {
        const double size = local.at_without(error.at, error.gap, error.draw);
        if (!(size > 0)) continue;
        squares += error.error * error.error / (size * size);
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

//! Drawn towards neighbours: the nearest errors change from place to place by leaps.
void smooth(std::vector<double>& values, const TriMesh& mesh) {
    constexpr int kSweeps = 10;
    std::vector<double> next(values.size());
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (const auto v : mesh.vertices()) {
            double sum = values[static_cast<std::size_t>(v.idx())];
            double count = 1;
            for (const auto w : mesh.vv_range(v)) {
                sum += values[static_cast<std::size_t>(w.idx())];
                ++count;
            }
            next[static_cast<std::size_t>(v.idx())] = sum / count;
        }
        values.swap(next);
    }
}

//! Distance of the nearest hole that knows, by plan vertex.
std::vector<double> gaps_of(const std::vector<Point2>& places, const std::vector<Point2>& know) {
    const NearestSites nearest(know);
    std::vector<NearSite> found;
    std::vector<double> gaps;
    for (const Point2& at : places) {
        nearest.nearest(at, 1, found);
        gaps.push_back(std::sqrt(found[0].squared_distance));
    }
    return gaps;
}

std::vector<double> face_areas(const TriMesh& plan) {
    std::vector<double> areas;
    for (const auto f : plan.faces()) areas.push_back(plan.calc_face_area(f));
    return areas;
}

//! Errors nearer to a hole than those known, and farther from all: they change with the root of the distance. 0 at a hole.
double growth(double gap, const GapProfile& known) {
    if (gap < known.gap.front()) return std::sqrt(gap / known.gap.front());
    const double last = known.gap.back();
    return gap > last && last > 0 ? std::sqrt(gap / last) : 1;
}

//! The expected size of an error, by plan vertex.
std::vector<double> local_sizes(const TriMesh& plan, const std::vector<Point2>& places,
                                const std::vector<double>& gaps, const LocalError& local,
                                const GapProfile& profile) {
    std::vector<double> sizes;
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double usual = profile.at(gaps[v]);
        sizes.push_back(usual > 0 ? local.at(places[v], gaps[v]) / usual : 1);
    }
    smooth(sizes, plan);
    for (std::size_t v = 0; v < places.size(); ++v) sizes[v] *= profile.at(gaps[v]);
    return sizes;
}

//! What nine in ten are no larger than.
double most_of(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
    std::ranges::nth_element(values, at);
    return *at;
}

//! Errors of single left-out holes and, where places are farther from holes than those are from each other, of left-out groups too.
struct LeftOut {
    KnowingHoles know;
    std::vector<PlacedError> errors;
};

LeftOut left_out(const LayerModel& model, const Survey& survey, const PredictedQuantity& quantity,
                 const ErrorSpreadOptions& options) {
    LeftOut result;
    std::vector<Point2> sites;
    for (const Borehole& hole : survey.holes) sites.push_back(hole.at);
    const auto add = [&](const std::vector<Draw>& all) {
        const std::vector<Draw> draws = without_last_contacts(survey, all);
        result.know =
            knowing_holes(survey, draws, [&](const Borehole& hole) { return knows(hole, quantity); });
        if (draws.empty() || result.know.at.size() < kFewestErrors) return;
        const std::size_t before = result.errors.empty() ? 0 : result.errors.back().draw + 1;
        for (PlacedError error : placed_errors(survey, draws, result.know, quantity, options.prediction)) {
            error.draw += before;
            result.errors.push_back(error);
        }
    };
    if (sites.size() <= kFewestErrors) return result;
    const std::size_t folds = std::min(options.folds, sites.size());
    add(fold_draws(sites.size(), folds, options.seed));
    const std::vector<double> gaps = plan_gaps(model, sites, face_areas(model.plan.surface));
    std::vector<double> known;
    for (const PlacedError& error : result.errors) known.push_back(error.gap);
    if (most_of(gaps) > most_of(known)) add(matched_draws(sites, gaps, folds, options.seed).draws);
    return result;
}

}  // namespace

ErrorSpread error_spread(const LayerModel& model, const Survey& survey, const PredictedQuantity& quantity,
                         Spread spread, const ErrorSpreadOptions& options) {
    const LeftOut out = left_out(model, survey, quantity, options);
    if (out.errors.size() < kFewestErrors)
        throw InvalidInput(
            fmt::format("only {} boreholes know it; how far off the model may be takes {} at least",
                        out.know.at.size(), kFewestErrors));
    const TriMesh& plan = model.plan.surface;
    std::vector<Point2> places;
    for (const auto v : plan.vertices())
        places.push_back({plan.point(v)[0] + model.origin.x, plan.point(v)[1] + model.origin.y});
    const std::vector<double> gaps = gaps_of(places, out.know.at);
    const LocalError local(out.errors);
    const GapProfile profile = ErrorByGap(local.errors()).profile();
    const std::vector<double> sizes = local_sizes(plan, places, gaps, local, profile);
    const PredictionReach reach =
        prediction_reach(local, spread == Spread::Deviation ? kUsualConfidence : options.confidence);
    const double deviation = deviation_over_size(local);
    ErrorSpread result{.size = {}, .errors = local.count(), .certain = reach.certain};
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double half_width = reach.half_width(sizes[v]);
        const double size = spread == Spread::Interval
                                ? half_width
                                : std::min(deviation * sizes[v], half_width / kDeviationsOfUsual);
        result.size.push_back(growth(gaps[v], profile) * size);
    }
    return result;
}

}  // namespace stratareeb
