// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/kriging.h"

#include <algorithm>
#include <cmath>

#include "boreholes/blended_surface.h"
#include "boreholes/errors.h"
#include "boreholes/fit_variogram.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

// A rough and a smooth one. With five to choose from, left-out holes of real surveys were predicted worse, and it takes longer.
const std::vector kModels{VariogramModel::Exponential, VariogramModel::Matern32};

//! The frame in whose coordinates an anisotropic variogram depends on distance alone, with its own range.
PlanFrame isotropic_frame(const PlanFrame& frame, const Variogram& v) {
    if (v.ratio == 1) return frame;
    const double c = std::cos(v.angle), s = std::sin(v.angle);
    return frame.then(c, s, -s / v.ratio, c / v.ratio);
}

void check(const Variogram& v) {
    const bool sound = v.nugget >= 0 && v.sill >= 0 && v.nugget + v.sill > 0 && v.range > 0 && v.ratio > 0 &&
                       std::isfinite(v.nugget + v.sill + v.range + v.ratio + v.angle);
    if (!sound)
        throw InvalidInput(
            "a variogram needs a nugget and a sill of at least 0 that are not both 0, and a range and a "
            "ratio above 0");
}

}  // namespace

Kriging::Kriging(std::shared_ptr<const HoleTriangulation> holes, int drift,
                 const InterpolatorOptions& options)
    : RadialInterpolator(std::move(holes), options.single_patch),
      drift_(drift),
      variogram_(options.variogram),
      filter_nugget_(options.filter_nugget),
      anisotropy_(options.anisotropy) {
    if (variogram_) check(*variogram_);
}

// In local coordinates and scaled values.
Variogram Kriging::fitted(const FieldSites& sites) const {
    const ValueScale scale = value_scale(sites);
    if (variogram_) {
        Variogram v = *variogram_;
        v.range *= sites.frame.xx;
        v.nugget /= scale.spread * scale.spread, v.sill /= scale.spread * scale.spread;
        return v;
    }
    std::vector<Point2> at;
    std::vector<double> value;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!sites.at_least[i])
            at.push_back(sites.at[i]), value.push_back((sites.value[i] - scale.mean) / scale.spread);
    return fit_variogram(at, value, {.models = kModels, .anisotropy = anisotropy_, .drift = drift_});
}

Kriging::FieldModel Kriging::model_of(const FieldSites& sites) const {
    const Variogram v = fitted(sites);
    FieldModel model;
    model.frame = isotropic_frame(sites.frame, v);
    model.honours_values = !filter_nugget_ || v.nugget == 0;
    const FieldSites stretched = in_frame(sites, holes().sites(), model.frame);
    const double micro_range = filter_nugget_ ? 0 : median_gap(stretched.at);
    model.radial = {covariance_kernel(v, micro_range), drift_, filter_nugget_ ? v.nugget : 0};
    return model;
}

Variogram Kriging::variogram_of(const SiteField& field) const {
    if (variogram_) return *variogram_;
    const FieldSites sites = field_sites(holes().sites(), field);
    const ValueScale scale = value_scale(sites);
    Variogram v = fitted(sites);
    v.range /= sites.frame.xx;
    v.nugget *= scale.spread * scale.spread, v.sill *= scale.spread * scale.spread;
    return v;
}

}  // namespace stratareeb
