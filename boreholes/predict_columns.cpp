// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/predict_columns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stratareeb {

namespace {

// As in mesh/layer_model: thinner is absent, as a share of the survey's size; hull triangles flatter than this are left out.
constexpr double kThinnest = 1e-9;
constexpr double kHullSliver = 0.05;

double size_of(const CompleteColumns& columns) {
    double size = 0;
    for (std::size_t h = 0; h < columns.sites.size(); ++h) {
        double depth = 0;
        for (const auto& layer : columns.thickness) depth += layer[h];
        size = std::max(size, depth);
    }
    const auto [x0, x1] = std::ranges::minmax(columns.sites, {}, &Point2::x);
    const auto [y0, y1] = std::ranges::minmax(columns.sites, {}, &Point2::y);
    const auto [z0, z1] = std::ranges::minmax(columns.ground);
    return std::max({size, z1 - z0, x1.x - x0.x, y1.y - y0.y});
}

std::vector<Point2> shifted(std::span<const Point2> places, const Point2& origin) {
    std::vector<Point2> local;
    local.reserve(places.size());
    for (const Point2& p : places) local.push_back({p.x - origin.x, p.y - origin.y});
    return local;
}

}  // namespace

double PredictedColumns::horizon(std::size_t k, std::size_t place) const {
    double z = ground[place];
    for (std::size_t i = 0; i < k; ++i) z -= thickness[i][place];
    return z;
}

ColumnPredictor::ColumnPredictor(const Survey& survey, const CompletionOptions& options, bool bare)
    : options_(options) {
    if (options.rules.any()) rules_ = rule_columns(survey, options);
    columns_ = options.rules.any() ? rules_.columns : complete_columns(survey, options);
    origin_ = columns_.sites.front();
    columns_.sites = shifted(columns_.sites, origin_);
    const double thinnest = kThinnest * size_of(columns_);
    for (auto& layer : columns_.thickness)
        for (double& t : layer)
            if (t < thinnest) t = 0;
    if (options.rules.any()) drop_thinner(rules_, thinnest);

    const auto plain = std::make_shared<const HoleTriangulation>(columns_.sites);
    holes_ = bare ? plain : std::make_shared<const HoleTriangulation>(columns_.sites, kHullSliver);
    const bool smooth = options.interpolator != InterpolatorKind::Linear;
    sites_ = smooth && !holes_->is_flat() ? holes_ : plain;
    field_ =
        std::make_unique<ThicknessField>(holes_, options.rules.any() ? rules_.thickness : columns_.thickness,
                                         options.pinch_out, make_interpolator(options.interpolator, sites_));
}

std::optional<double> ColumnPredictor::terrain(const Point2& local) const {
    if (!options_.terrain) return std::nullopt;
    return options_.terrain({local.x + origin_.x, local.y + origin_.y});
}

// The terrain, bent to pass through the elevations that holes give; without one, the holes' elevations.
std::vector<double> ColumnPredictor::ground(std::span<const Point2> local) const {
    const auto interpolator = make_interpolator(options_.interpolator, sites_);
    if (!options_.terrain)
        return interpolator->predict(local, std::vector<SiteField>{{columns_.ground, {}}})[0];
    std::vector<double> misfit(columns_.ground);
    std::vector<char> knows(misfit.size(), 0);
    for (std::size_t h = 0; h < misfit.size(); ++h)
        if (const auto z = terrain(columns_.sites[h])) misfit[h] -= *z, knows[h] = 1;
    auto fields =
        interpolator->predict(local, std::vector<SiteField>{{columns_.ground, {}}, {misfit, knows}});
    for (std::size_t p = 0; p < local.size(); ++p)
        if (const auto z = terrain(local[p])) fields[0][p] = *z + fields[1][p];
    return std::move(fields[0]);
}

std::vector<std::vector<double>> ColumnPredictor::ruled(std::span<const Point2> local,
                                                        std::span<const double> ground) const {
    std::vector<std::vector<double>> result(field_->layers(), std::vector<double>(local.size()));
    const auto interpolator = make_interpolator(options_.interpolator, sites_);
    const std::vector<UncutColumn> uncut = uncut_columns(rules_, *field_, *interpolator, local, ground);
    for (std::size_t p = 0; p < local.size(); ++p) {
        std::vector<double> thickness = stacked_thicknesses(uncut[p], rules_.sequences);
        apply_minimum(thickness, options_.rules);
        for (std::size_t i = 0; i < thickness.size(); ++i) result[i][p] = thickness[i];
    }
    return result;
}

PredictedColumns ColumnPredictor::at(std::span<const Point2> where) const {
    const std::vector<Point2> local = shifted(where, origin_);
    PredictedColumns result;
    result.ground = ground(local);
    result.thickness = options_.rules.any() ? ruled(local, result.ground) : field_->predict(local);
    for (auto& layer : result.thickness)
        for (double& t : layer) t = std::max(t, 0.0);
    for (const PlanLocation& location : holes_->locate(local))
        result.inside.push_back(static_cast<char>(location.inside));
    return result;
}

}  // namespace stratareeb
