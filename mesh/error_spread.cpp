// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/error_spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "boreholes/error_by_gap.h"
#include "boreholes/errors.h"
#include "boreholes/hold_out.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/placed_errors.h"
#include "boreholes/prediction_intervals.h"

namespace stratareeb {

namespace {

constexpr std::size_t kFewestErrors = 5;

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

//! Distance of the nearest hole that knows, and the expected size of an error, at each plan vertex.
struct LocalSizes {
    std::vector<double> gap, size;
};

LocalSizes local_sizes(const LayerModel& model, const KnowingHoles& know, const LocalError& local,
                       const GapProfile& profile) {
    const TriMesh& plan = model.plan.surface;
    LocalSizes result{std::vector<double>(plan.n_vertices()), std::vector<double>(plan.n_vertices())};
    const NearestSites nearest(know.at);
    std::vector<NearSite> found;
    for (const auto v : plan.vertices()) {
        const auto& p = plan.point(v);
        const Point2 at{p[0] + model.origin.x, p[1] + model.origin.y};
        nearest.nearest(at, 1, found);
        const auto i = static_cast<std::size_t>(v.idx());
        result.gap[i] = std::sqrt(found[0].squared_distance);
        const double usual = profile.at(result.gap[i]);
        result.size[i] = usual > 0 ? local.at(at, result.gap[i]) / usual : 1;
    }
    smooth(result.size, plan);
    for (std::size_t i = 0; i < result.size.size(); ++i) result.size[i] *= profile.at(result.gap[i]);
    return result;
}

//! 0 at a hole, 1 from the distance on at which errors are known.
double nearness(double gap, double first_known) {
    return gap >= first_known ? 1 : std::sqrt(gap / first_known);
}

}  // namespace

ErrorSpread error_spread(const LayerModel& model, const Survey& survey, const PredictedQuantity& quantity,
                         Spread spread, const ErrorSpreadOptions& options) {
    std::vector<Draw> draws;
    if (survey.holes.size() > kFewestErrors)
        draws = without_last_contacts(
            survey,
            fold_draws(survey.holes.size(), std::min(options.folds, survey.holes.size()), options.seed));
    const KnowingHoles know =
        knowing_holes(survey, draws, [&](const Borehole& hole) { return knows(hole, quantity); });
    if (draws.empty() || know.at.size() < kFewestErrors)
        throw InvalidInput(
            fmt::format("only {} boreholes know it; how far off the model may be takes {} at least",
                        know.at.size(), kFewestErrors));
    const LocalError local(placed_errors(survey, draws, know, quantity, options.prediction));
    const GapProfile profile = ErrorByGap(local.errors()).profile();
    const PredictionReach reach = prediction_reach(local, options.confidence);
    const double deviation = deviation_over_size(local);
    const LocalSizes sizes = local_sizes(model, know, local, profile);
    ErrorSpread result{.size = {}, .errors = local.count(), .certain = reach.certain};
    for (std::size_t v = 0; v < sizes.size.size(); ++v)
        result.size.push_back(
            nearness(sizes.gap[v], profile.gap.front()) *
            (spread == Spread::Deviation ? deviation * sizes.size[v] : reach.half_width(sizes.size[v])));
    return result;
}

}  // namespace stratareeb
