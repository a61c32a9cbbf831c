// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/radial_interpolator.h"

#include <algorithm>
#include <cmath>

#include "boreholes/blended_surface.h"
#include "boreholes/closest_in_hull.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

// Beyond the hull the surface goes on so far, in diagonals of the sites' box; from there on outward it is level. Ten-fold
// hold-outs of real surveys, whose outer holes are beyond the hull of the rest, favour going on over stopping at the hull.
constexpr double kReach = 0.25;

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

}  // namespace

FieldPrediction RadialInterpolator::predict_field(std::span<const Point2> where, const SiteField& field,
                                                  bool deviations) const {
    FieldPrediction result{std::vector<double>(where.size()),
                           std::vector<double>(deviations ? where.size() : 0)};
    FieldSites sites = field_sites(holes_->sites(), field);
    if (sites.size() == 0) return result;
    if (sites.measured == 0) sites = with_bounds_as_values(std::move(sites));
    if (const double* value = only_value(sites)) {
        std::ranges::fill(result.value, *value);
        return result;
    }
    const FieldModel model = model_of(sites);
    sites = in_frame(sites, holes_->sites(), model.frame);
    std::vector<Point2> local(where.size());
    std::ranges::transform(where, local.begin(), [&](const Point2& p) { return sites.frame.to_local(p); });
    auto found = BlendedSurface(sites, model.radial, cover()).at(local, deviations);
    result = {std::move(found.value), std::move(found.deviation)};
    for (double& d : result.deviation) d *= std::sqrt(model.variance_factor);
    if (!model.honours_values) return result;
    const SiteLookup lookup(holes_->sites(), sites);
    for (std::size_t i = 0; i < where.size(); ++i) {
        const double* value = lookup.value_at(where[i]);
        if (!value) continue;
        result.value[i] = *value;
        if (deviations) result.deviation[i] = 0;
    }
    return result;
}

std::vector<std::vector<double>> RadialInterpolator::predict(std::span<const Point2> where,
                                                             std::span<const SiteField> fields) const {
    const auto near = closest_in_reach(*holes_, where, kReach * extent_of(holes_->sites()));
    std::vector<std::vector<double>> result;
    for (const SiteField& field : fields) result.push_back(predict_field(near, field, false).value);
    return result;
}

std::vector<FieldPrediction> RadialInterpolator::predict_with_deviation(
    std::span<const Point2> where, std::span<const SiteField> fields) const {
    const auto near = closest_in_reach(*holes_, where, kReach * extent_of(holes_->sites()));
    std::vector<FieldPrediction> result;
    for (const SiteField& field : fields) result.push_back(predict_field(near, field, true));
    return result;
}

}  // namespace stratareeb
