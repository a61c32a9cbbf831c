// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/volume_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "boreholes/hold_out.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/student_t.h"

namespace stratareeb {

namespace {

//! What a hole knows of a layer's thickness inside the window.
std::optional<double> actual_thickness(const Borehole& hole, std::size_t layer, const VolumeWindow& window) {
    const auto &ground = hole.horizons[0], &top = hole.horizons[layer], &base = hole.horizons[layer + 1];
    if (window.elevations || window.depths) {
        if (!ground || !top || !base) return std::nullopt;
        return window.thickness(*ground, *top, *base);
    }
    if (hole.layers[layer].knowledge == Knowledge::Measured) return hole.layers[layer].thickness;
    if (top && base) return *top - *base;
    return std::nullopt;
}

//! Errors of one layer, or of all, and the holes they were found at, ascending.
struct Errors {
    std::vector<std::size_t> holes;
    std::vector<double> values;
};

std::vector<Errors> errors_of(const Survey& survey, const std::vector<HeldOutHole>& held,
                              const VolumeWindow& window) {
    const std::size_t layers = survey.units.size();
    std::vector<Errors> result(layers + 1);
    for (const HeldOutHole& out : held) {
        double sum = 0;
        bool all = true;
        for (std::size_t i = 0; i < layers; ++i) {
            const auto actual = actual_thickness(survey.holes[out.hole], i, window);
            const double predicted =
                window.elevations || window.depths
                    ? window.thickness(out.horizons[0], out.horizons[i], out.horizons[i + 1])
                    : out.thickness[i];
            all = all && actual;
            if (!actual) continue;
            result[i].holes.push_back(out.hole);
            result[i].values.push_back(predicted - *actual);
            sum += predicted - *actual;
        }
        if (!all) continue;
        result[layers].holes.push_back(out.hole);
        result[layers].values.push_back(sum);
    }
    return result;
}

//! The parts of the plan and of the window nearest to each of some holes.
struct Blocks {
    std::vector<double> plan, window;
};

Blocks blocks_of(const LayerModel& model, const Survey& survey, const std::vector<std::size_t>& holes,
                 const WindowVolumes& volumes) {
    std::vector<Point2> sites;
    for (const std::size_t hole : holes) sites.push_back(survey.holes[hole].at);
    const NearestSites nearest(sites);
    Blocks blocks{std::vector(sites.size(), 0.0), std::vector(sites.size(), 0.0)};
    std::vector<NearSite> found;
    for (const auto f : model.plan.surface.faces()) {
        const auto middle = model.plan.surface.calc_face_centroid(f);
        nearest.nearest({middle[0] + model.origin.x, middle[1] + model.origin.y}, 1, found);
        blocks.plan[found[0].site] += model.plan.surface.calc_face_area(f);
        blocks.window[found[0].site] += volumes.plan_area[static_cast<std::size_t>(f.idx())];
    }
    return blocks;
}

VolumeUncertainty uncertainty_of(const std::vector<double>& errors, const Blocks& blocks, double confidence) {
    double area = 0, sum = 0, squares = 0, window = 0, window_squares = 0;
    for (std::size_t h = 0; h < errors.size(); ++h) {
        area += blocks.plan[h];
        sum += blocks.plan[h] * errors[h];
        squares += blocks.plan[h] * errors[h] * errors[h];
        window += blocks.window[h];
        window_squares += blocks.window[h] * blocks.window[h];
    }
    VolumeUncertainty result{
        .holes = errors.size(), .rmse = std::sqrt(squares / area), .mean_error = sum / area};
    result.standard_error = std::hypot(result.mean_error * window, result.rmse * std::sqrt(window_squares));
    result.half_width = result.standard_error * quantile(MeanLaw::StudentT, 0.5 + confidence / 2,
                                                         static_cast<double>(errors.size() - 1));
    return result;
}

}  // namespace

std::vector<VolumeUncertainty> volume_uncertainty(const LayerModel& model, const Survey& survey,
                                                  const VolumeWindow& window, const WindowVolumes& volumes,
                                                  const VolumeUncertaintyOptions& options) {
    std::vector<VolumeUncertainty> result(survey.units.size() + 1);
    if (survey.holes.size() < 4) return result;
    const std::size_t folds = std::min(options.folds, survey.holes.size());
    const auto draws = without_last_contacts(survey, fold_draws(survey.holes.size(), folds, options.seed));
    const auto held = hold_out(survey, draws, {.prediction = options.prediction});
    const auto errors = errors_of(survey, held, window);
    std::map<std::vector<std::size_t>, Blocks> known;  // layers that the same holes know share theirs
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto& holes = errors[i].holes;
        result[i].holes = holes.size();
        if (holes.size() < 2) continue;
        auto blocks = known.find(holes);
        if (blocks == known.end())
            blocks = known.emplace(holes, blocks_of(model, survey, holes, volumes)).first;
        result[i] = uncertainty_of(errors[i].values, blocks->second, options.confidence);
    }
    return result;
}

}  // namespace stratareeb
