// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/predict_columns.h"

#include <algorithm>

namespace stratareeb {

namespace {

double extent_in_plan(const std::vector<Point2>& sites) {
    const auto [x0, x1] = std::ranges::minmax(sites, {}, &Point2::x);
    const auto [y0, y1] = std::ranges::minmax(sites, {}, &Point2::y);
    return std::max(x1.x - x0.x, y1.y - y0.y);
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
    : rules_(options.rules), field_(survey, options) {
    const Point2 first = field_.columns().sites.front();
    field_.move_origin({first.x, first.y, 0});
    field_.prepare(extent_in_plan(field_.columns().sites), bare);
}

std::vector<std::vector<double>> ColumnPredictor::ruled(std::span<const Point2> local,
                                                        std::span<const double> ground) const {
    std::vector<std::vector<double>> result(field_.thickness().layers(), std::vector<double>(local.size()));
    const std::vector<UncutColumn> uncut = field_.uncut(local, ground);
    for (std::size_t p = 0; p < local.size(); ++p) {
        std::vector<double> thickness = stacked_thicknesses(uncut[p], field_.rules().sequences);
        apply_minimum(thickness, rules_);
        for (std::size_t i = 0; i < thickness.size(); ++i) result[i][p] = thickness[i];
    }
    return result;
}

PredictedColumns ColumnPredictor::at(std::span<const Point2> where) const {
    const std::vector<Point2> local = shifted(where, {field_.origin().x, field_.origin().y});
    PredictedColumns result;
    result.ground = field_.ground(local);
    result.thickness = field_.is_ruled() ? ruled(local, result.ground) : field_.thickness().predict(local);
    for (auto& layer : result.thickness)
        for (double& t : layer) t = std::max(t, 0.0);
    for (const PlanLocation& location : field_.holes().locate(local))
        result.inside.push_back(static_cast<char>(location.inside));
    return result;
}

}  // namespace stratareeb
