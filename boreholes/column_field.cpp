// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/column_field.h"

#include <algorithm>

namespace stratareeb {

namespace {

// The thinnest a layer may be where it is present at all, as a share of the model's size: thick enough to
// survive the subtraction of elevations, thin enough to be nothing.
constexpr double kThinnest = 1e-9;
// Triangles along the hull that are flatter than this are left out: pinch-out lines would run close beside the model's wall.
constexpr double kHullSliver = 0.05;

double depth_and_relief(const CompleteColumns& columns) {
    double deepest = 0;
    for (std::size_t h = 0; h < columns.sites.size(); ++h) {
        double depth = 0;
        for (const auto& layer : columns.thickness) depth += layer[h];
        deepest = std::max(deepest, depth);
    }
    const auto [z0, z1] = std::ranges::minmax(columns.ground);
    return std::max(deepest, z1 - z0);
}

std::vector<std::vector<double>> least_thicknesses(const Survey& survey) {
    std::vector<std::vector<double>> bounds(survey.units.size(),
                                            std::vector<double>(survey.holes.size(), 0.0));
    for (std::size_t h = 0; h < survey.holes.size(); ++h)
        for (std::size_t i = 0; i < survey.holes[h].layers.size(); ++i)
            bounds[i][h] = survey.holes[h].layers[i].thickness;
    return bounds;
}

}  // namespace

ColumnField::ColumnField(const Survey& survey, const CompletionOptions& options)
    : options_(options), bounds_(least_thicknesses(survey)) {
    if (is_ruled()) rules_ = rule_columns(survey, options);
    columns_ = is_ruled() ? rules_.columns : complete_columns(survey, options);
}

void ColumnField::move_origin(const Point3& origin) {
    const Point3 by{origin.x - origin_.x, origin.y - origin_.y, origin.z - origin_.z};
    for (Point2& p : columns_.sites) p = {p.x - by.x, p.y - by.y};
    for (double& z : columns_.ground) z -= by.z;
    for (auto& anchor : rules_.anchor)
        for (double& z : anchor) z -= by.z;
    origin_ = origin;
}

void ColumnField::prepare(double extent, bool bare) {
    drop_thin_layers(extent);
    const auto plain = std::make_shared<const HoleTriangulation>(columns_.sites);
    holes_ = bare ? plain : std::make_shared<const HoleTriangulation>(columns_.sites, kHullSliver);
    const bool smooth = options_.interpolator != InterpolatorKind::Linear;
    sites_ = smooth && !holes_->is_flat() ? holes_ : plain;
    // Through its own predictions a surface of these kinds would be too sure of itself.
    const bool facts_only = !is_ruled() && takes_bounds(options_.interpolator);
    field_ = std::make_unique<ThicknessField>(holes_, is_ruled() ? rules_.thickness : columns_.thickness,
                                              options_.pinch_out, interpolator(),
                                              facts_only ? columns_.known : std::vector<std::vector<char>>{});
    if (facts_only) settle_unknown();
}

void ColumnField::drop_thin_layers(double extent) {
    thinnest_ = kThinnest * std::max(extent, depth_and_relief(columns_));
    if (is_ruled()) {
        drop_thinner(rules_, thinnest_);
        columns_.thickness = rules_.columns.thickness;
    }
    for (auto& layer : columns_.thickness)
        for (double& t : layer)
            if (t < thinnest_) t = 0;
}

//! What holes don't know is what the field says there, so that it is smooth around them.
void ColumnField::settle_unknown() {
    if (columns_.known.empty()) return;
    const auto& known = columns_.known;
    std::vector<std::size_t> open;
    std::vector<Point2> where;
    for (std::size_t h = 0; h < columns_.sites.size(); ++h) {
        const bool all = std::ranges::all_of(known, [h](const auto& layer) { return layer[h] != 0; });
        if (!all) open.push_back(h), where.push_back(columns_.sites[h]);
    }
    if (open.empty()) return;
    const auto thickness = field_->predict(where);
    for (std::size_t i = 0; i < known.size(); ++i)
        for (std::size_t m = 0; m < open.size(); ++m)
            if (double& t = columns_.thickness[i][open[m]]; t > 0 && !known[i][open[m]])
                t = std::max({thickness[i][m], bounds_[i][open[m]], thinnest_});
}

std::optional<double> ColumnField::terrain(const Point2& p) const {
    if (!options_.terrain) return std::nullopt;
    const auto z = options_.terrain({p.x + origin_.x, p.y + origin_.y});
    return z ? std::optional(*z - origin_.z) : std::nullopt;
}

std::unique_ptr<Interpolator> ColumnField::interpolator() const {
    return make_interpolator(options_.interpolator, sites_);
}

std::vector<double> ColumnField::ground(std::span<const Point2> where) const {
    if (!options_.terrain)
        return interpolator()->predict(where, std::vector<SiteField>{{columns_.ground, {}}})[0];
    std::vector<double> misfit(columns_.ground);
    std::vector<char> knows(misfit.size(), 0);
    for (std::size_t h = 0; h < misfit.size(); ++h)
        if (const auto z = terrain(columns_.sites[h])) misfit[h] -= *z, knows[h] = 1;
    auto fields =
        interpolator()->predict(where, std::vector<SiteField>{{columns_.ground, {}}, {misfit, knows}});
    for (std::size_t p = 0; p < where.size(); ++p)
        if (const auto z = terrain(where[p])) fields[0][p] = *z + fields[1][p];
    return std::move(fields[0]);
}

std::vector<UncutColumn> ColumnField::uncut(std::span<const Point2> where,
                                            std::span<const double> ground) const {
    return uncut_columns(rules_, *field_, *interpolator(), where, ground);
}

}  // namespace stratareeb
