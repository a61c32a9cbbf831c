// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/volume_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "boreholes/error_by_gap.h"
#include "boreholes/hold_out.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/student_t.h"
#include "mesh/matched_draws.h"
#include "mesh/plan_gaps.h"

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
    std::vector<double> values, actual;
};

std::vector<Errors> errors_of(const Survey& survey, const std::vector<HeldOutHole>& held,
                              const VolumeWindow& window) {
    const std::size_t layers = survey.units.size();
    std::vector<Errors> result(layers + 1);
    for (const HeldOutHole& out : held) {
        double sum = 0, whole = 0;
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
            result[i].actual.push_back(*actual);
            sum += predicted - *actual;
            whole += *actual;
        }
        if (!all) continue;
        result[layers].holes.push_back(out.hole);
        result[layers].values.push_back(sum);
        result[layers].actual.push_back(whole);
    }
    return result;
}

//! A triangle of the plan: the hole nearest to its middle, how far that is, and its area in the window.
struct Part {
    std::size_t hole = 0;
    double gap = 0, window = 0;
};

//! The parts of the plan and of the window nearest to each of some holes.
struct Blocks {
    std::vector<double> plan, window;
    std::vector<Part> parts;
    double gap = 0;  // of the left-out holes to those that predicted them; a mean by the area they stand for
};

Blocks blocks_of(const LayerModel& model, const Survey& survey, const std::vector<std::size_t>& holes,
                 const std::vector<std::size_t>& draw_of, const WindowVolumes& volumes) {
    std::vector<Point2> sites;
    std::vector<std::size_t> draw, asked;
    for (const std::size_t hole : holes) {
        asked.push_back(sites.size());
        sites.push_back(survey.holes[hole].at);
        draw.push_back(draw_of[hole]);
    }
    const NearestSites nearest(sites);
    Blocks blocks{std::vector(sites.size(), 0.0), std::vector(sites.size(), 0.0), {}};
    std::vector<NearSite> found;
    for (const auto f : model.plan.surface.faces()) {
        const auto middle = model.plan.surface.calc_face_centroid(f);
        nearest.nearest({middle[0] + model.origin.x, middle[1] + model.origin.y}, 1, found);
        const double window = volumes.plan_area[static_cast<std::size_t>(f.idx())];
        blocks.plan[found[0].site] += model.plan.surface.calc_face_area(f);
        blocks.window[found[0].site] += window;
        blocks.parts.push_back({found[0].site, std::sqrt(found[0].squared_distance), window});
    }
    const std::vector<double> gaps = gaps_to_other_draws(sites, draw, asked);
    double area = 0;
    for (std::size_t h = 0; h < sites.size(); ++h) {
        area += blocks.plan[h];
        blocks.gap += blocks.plan[h] * gaps[h];
    }
    blocks.gap /= area;
    return blocks;
}

//! The window's area by block, each part counted as often as errors there are larger than those of left-out holes: they grow with
//! the root of the distance (a linear variogram), up to what is not to know anything but the mean.
std::vector<double> weighed_areas(const Blocks& blocks, double most) {
    std::vector<double> areas(blocks.window.size(), 0.0);
    for (const Part& part : blocks.parts) {
        const double growth = part.gap > blocks.gap ? std::sqrt(part.gap / blocks.gap) : 1;
        areas[part.hole] += part.window * std::min(growth, most);
    }
    return areas;
}

double deviation(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    const auto count = static_cast<double>(values.size());
    for (const double value : values) sum += value;
    for (const double value : values) squares += (value - sum / count) * (value - sum / count);
    return std::sqrt(squares / (count - 1));
}

//! Errors by groups of holes left out together, which are alike: area in the plan, mean error, and counted area in the window.
struct Group {
    double plan = 0, error = 0, window = 0;
};

std::vector<Group> groups_of(const Errors& of, const Blocks& blocks, const std::vector<double>& weighed,
                             const std::vector<std::size_t>& group_of) {
    std::map<std::size_t, Group> groups;
    for (std::size_t h = 0; h < of.values.size(); ++h) {
        Group& group = groups[group_of[of.holes[h]]];
        group.plan += blocks.plan[h];
        group.error += blocks.plan[h] * of.values[h];
        group.window += weighed[h];
    }
    std::vector<Group> result;
    for (auto& [number, group] : groups) {
        if (group.plan > 0) group.error /= group.plan;
        result.push_back(group);
    }
    return result;
}

VolumeUncertainty uncertainty_of(const Errors& of, const Blocks& blocks,
                                 const std::vector<std::size_t>& group_of, double confidence) {
    const std::vector<double>& errors = of.values;
    double area = 0, sum = 0, squares = 0, window = 0;
    for (std::size_t h = 0; h < errors.size(); ++h) {
        area += blocks.plan[h];
        sum += blocks.plan[h] * errors[h];
        squares += blocks.plan[h] * errors[h] * errors[h];
        window += blocks.window[h];
    }
    VolumeUncertainty result{
        .holes = errors.size(), .rmse = std::sqrt(squares / area), .mean_error = sum / area};
    const double most = result.rmse > 0 ? std::max(1.0, deviation(of.actual) / result.rmse) : 1;
    const auto groups = groups_of(of, blocks, weighed_areas(blocks, most), group_of);
    double group_squares = 0, weighed_squares = 0;
    for (const Group& group : groups) {
        group_squares += group.plan * group.error * group.error;
        weighed_squares += group.window * group.window;
    }
    result.groups = groups.size();
    if (groups.size() < 2) return result;
    result.standard_error =
        std::hypot(result.mean_error * window, std::sqrt(group_squares / area * weighed_squares));
    result.half_width = result.standard_error * quantile(MeanLaw::StudentT, 0.5 + confidence / 2,
                                                         static_cast<double>(groups.size() - 1));
    return result;
}

}  // namespace

std::vector<VolumeUncertainty> volume_uncertainty(const LayerModel& model, const Survey& survey,
                                                  const VolumeWindow& window, const WindowVolumes& volumes,
                                                  const VolumeUncertaintyOptions& options) {
    std::vector<VolumeUncertainty> result(survey.units.size() + 1);
    if (survey.holes.size() < 4) return result;
    const std::size_t folds = std::min(options.folds, survey.holes.size());
    std::vector<Point2> sites;
    for (const Borehole& hole : survey.holes) sites.push_back(hole.at);
    const MatchedDraws matched =
        matched_draws(sites, plan_gaps(model, sites, volumes.plan_area), folds, options.seed);
    const auto draws = without_last_contacts(survey, matched.draws);
    const auto held = hold_out(survey, draws, {.prediction = options.prediction});
    const auto errors = errors_of(survey, held, window);
    std::vector<std::size_t> draw_of(survey.holes.size());
    for (std::size_t h = 0; h < draw_of.size(); ++h) draw_of[h] = draws.size() + h;  // in none
    for (std::size_t d = 0; d < draws.size(); ++d)
        for (const std::size_t h : draws[d]) draw_of[h] = d;
    std::map<std::vector<std::size_t>, Blocks> known;  // layers that the same holes know share theirs
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto& holes = errors[i].holes;
        result[i].holes = holes.size();
        if (holes.size() < 2) continue;
        auto blocks = known.find(holes);
        if (blocks == known.end())
            blocks = known.emplace(holes, blocks_of(model, survey, holes, draw_of, volumes)).first;
        result[i] = uncertainty_of(errors[i], blocks->second, matched.group, options.confidence);
    }
    return result;
}

}  // namespace stratareeb
