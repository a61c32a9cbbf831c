// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/radial_interpolator.h"

#include <algorithm>
#include <cmath>

#include "boreholes/blended_surface.h"
#include "boreholes/closest_in_hull.h"
#include "boreholes/reconcile_layers.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

// Beyond the hull the surface goes on so far, in diagonals of the sites' box; from there on outward it is level. Ten-fold
// hold-outs of real surveys, whose outer holes are beyond the hull of the rest, favour going on over stopping at the hull.
constexpr double kReach = 0.25;
constexpr double kTogether =
    0.4;  // of the sites that know a layer, the share that must know its neighbour too

//! The value that all sites have, or null. A bound below it says nothing.
const double* only_value(const FieldSites& sites) {
    const double* one = nullptr;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (sites.at_least[i]) continue;
        if (one && *one != sites.value[i]) return nullptr;
        one = &sites.value[i];
    }
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (one && sites.at_least[i] && sites.value[i] > *one) return nullptr;
    return one;
}

//! Bounds alone are the best guess that there is.
FieldSites with_bounds_as_values(FieldSites sites) {
    std::ranges::fill(sites.at_least, static_cast<char>(0));
    sites.measured = sites.size();
    return sites;
}

bool has_say(const SiteField& field, std::size_t site) {
    return field.use.empty() || field.use[site];
}

//! Is the layer's thickness known there, be it 0?
bool is_known(const LayerFields& layers, std::size_t layer, std::size_t site) {
    return layers.known.empty() ? has_say(layers.thickness[layer], site) : layers.known[layer][site] != 0;
}

double taper_at(const LayerFields& layers, std::size_t layer, std::size_t place) {
    return layers.taper.empty() ? 1.0 : layers.taper[layer][place];
}

//! Layers whose depths are worth a prediction of their own: most sites that know one of them know both.
bool go_together(const LayerFields& layers, std::size_t a, std::size_t b) {
    const auto& fields = layers.thickness;
    if (!fields[a].at_least.empty() || !fields[b].at_least.empty()) return false;
    double both = 0, of_a = 0, of_b = 0;
    for (std::size_t s = 0; s < fields[a].value.size(); ++s) {
        const bool in_a = is_known(layers, a, s), in_b = is_known(layers, b, s);
        both += in_a && in_b, of_a += in_a, of_b += in_b;
    }
    return both >= kTogether * std::max(of_a, of_b);
}

ValueLimits limits_of(const SiteField& field) {
    std::vector<double> known;
    for (std::size_t s = 0; s < field.value.size(); ++s)
        if (has_say(field, s)) known.push_back(field.value[s]);
    return value_limits(known);
}

}  // namespace

RadialInterpolator::RatedField RadialInterpolator::predict_field(std::span<const Point2> where,
                                                                 const SiteField& field,
                                                                 Extras extras) const {
    RatedField result{{std::vector<double>(where.size()), {}}, 0};
    auto& [value, deviation] = result.prediction;
    if (extras.deviations) deviation.assign(where.size(), 0.0);
    FieldSites sites = field_sites(holes_->sites(), field);
    if (sites.size() == 0) return result;
    if (sites.measured == 0) sites = with_bounds_as_values(std::move(sites));
    if (const double* only = only_value(sites)) {
        std::ranges::fill(value, *only);
        return result;
    }
    const FieldModel model = model_of(sites);
    sites = in_frame(sites, holes_->sites(), model.frame);
    std::vector<Point2> local(where.size());
    std::ranges::transform(where, local.begin(), [&](const Point2& p) { return sites.frame.to_local(p); });
    const BlendedSurface surface(sites, model.radial, cover());
    auto found = surface.at(local, extras.deviations);
    if (extras.error) result.error = surface.leave_one_out_rms() * value_scale(sites).spread;
    value = std::move(found.value), deviation = std::move(found.deviation);
    for (double& d : deviation) d *= std::sqrt(model.variance_factor);
    if (!model.honours_values) return result;
    const SiteLookup lookup(holes_->sites(), sites);
    for (std::size_t i = 0; i < where.size(); ++i) {
        const double* given = lookup.value_at(where[i]);
        if (!given) continue;
        value[i] = *given;
        if (extras.deviations) deviation[i] = 0;
    }
    return result;
}

std::vector<Point2> RadialInterpolator::in_reach(std::span<const Point2> where) const {
    return closest_in_reach(*holes_, where, kReach * extent_of(holes_->sites()));
}

std::vector<std::vector<double>> RadialInterpolator::predict(std::span<const Point2> where,
                                                             std::span<const SiteField> fields) const {
    const auto near = in_reach(where);
    std::vector<std::vector<double>> result;
    for (const SiteField& field : fields)
        result.push_back(std::move(predict_field(near, field, {}).prediction.value));
    return result;
}

//! Neighbouring layers that are known at much the same sites. A depth is known where all layers down to it are.
void RadialInterpolator::predict_run(std::span<const Point2> where, const LayerFields& fields,
                                     std::size_t begin, std::size_t end,
                                     std::vector<std::vector<double>>& result) const {
    const Extras extras{.error = end - begin > 1};
    std::vector<RatedPrediction> layers, depths;
    std::vector<double> depth(holes_->sites().size(), 0.0);
    std::vector<char> all(depth.size(), 1);
    for (std::size_t i = begin; i < end; ++i) {
        const SiteField& field = fields.thickness[i];
        RatedField layer = predict_field(where, field, extras);
        layers.push_back({std::move(layer.prediction.value), layer.error});
        for (std::size_t s = 0; s < depth.size(); ++s)
            depth[s] += field.value[s], all[s] = static_cast<char>(all[s] && is_known(fields, i, s));
        if (i == begin) {
            depths.emplace_back();
            continue;
        }
        RatedField sum = predict_field(where, {depth, all}, extras);
        depths.push_back({std::move(sum.prediction.value), sum.error});
    }
    if (!fields.taper.empty())
        for (std::size_t i = begin; i < end; ++i) {
            layers[i - begin].share = fields.taper[i];
            for (std::size_t p = 0; p < where.size(); ++p) layers[i - begin].value[p] *= fields.taper[i][p];
        }
    auto columns = reconcile_layers(layers, depths);
    for (std::size_t i = begin; i < end; ++i) {
        const ValueLimits limits = limits_of(fields.thickness[i]);
        std::vector<double>& values = columns[i - begin];
        for (std::size_t p = 0; p < where.size(); ++p) {
            const double taper = taper_at(fields, i, p);
            if (taper > 0) values[p] = limits.clamp(values[p] / taper);
        }
        result.push_back(std::move(values));
    }
}

std::vector<std::vector<double>> RadialInterpolator::predict_layers(std::span<const Point2> where,
                                                                    const LayerFields& layers) const {
    const auto near = in_reach(where);
    std::vector<std::vector<double>> result;
    for (std::size_t begin = 0, end = 0; begin < layers.thickness.size(); begin = end) {
        for (end = begin + 1; end < layers.thickness.size(); ++end)
            if (!go_together(layers, begin, end)) break;
        predict_run(near, layers, begin, end, result);
    }
    return result;
}

std::vector<FieldPrediction> RadialInterpolator::predict_with_deviation(
    std::span<const Point2> where, std::span<const SiteField> fields) const {
    const auto near = in_reach(where);
    std::vector<FieldPrediction> result;
    for (const SiteField& field : fields)
        result.push_back(predict_field(near, field, {.deviations = true}).prediction);
    return result;
}

}  // namespace stratareeb
