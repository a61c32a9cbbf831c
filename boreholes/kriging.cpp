// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/kriging.h"

#include <algorithm>
#include <cmath>

#include "boreholes/blended_surface.h"
#include "boreholes/errors.h"
#include "boreholes/fit_variogram.h"
#include "boreholes/mean_covariance.h"
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

struct Measured {
    std::vector<Point2> at;
    std::vector<double> value;  // scaled
};

Measured measured(const FieldSites& sites) {
    const ValueScale scale = value_scale(sites);
    Measured result;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!sites.at_least[i])
            result.at.push_back(sites.at[i]),
                result.value.push_back((sites.value[i] - scale.mean) / scale.spread);
    return result;
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

Variogram Kriging::local(Variogram v, const FieldSites& sites) const {
    const double spread = value_scale(sites).spread;
    v.range *= sites.frame.xx;
    v.nugget /= spread * spread, v.sill /= spread * spread;
    return v;
}

Kriging::FieldModel Kriging::model_with(const Variogram& v, const FieldSites& sites) const {
    FieldModel model;
    model.frame = isotropic_frame(sites.frame, v);
    model.honours_values = !filter_nugget_ || v.nugget == 0;
    const FieldSites stretched = in_frame(sites, holes().sites(), model.frame);
    const double micro_range = filter_nugget_ ? 0 : median_gap(stretched.at);
    model.radial = {covariance_kernel(v, micro_range), drift_, filter_nugget_ ? v.nugget : 0};
    return model;
}

Kriging::FieldModel Kriging::mean_model(const FieldSites& sites) const {
    const auto [at, value] = measured(sites);
    const MeanCovariance mean = mean_covariance(at, value, drift_);
    FieldModel model;
    model.frame = sites.frame;
    model.honours_values = !filter_nugget_ || mean.nugget == 0;
    const double micro_range = filter_nugget_ ? 0 : median_gap(sites.at);
    model.radial = {mean_covariance_kernel(mean, micro_range), drift_, filter_nugget_ ? mean.nugget : 0};
    return model;
}

Kriging::FieldModel Kriging::model_of(const FieldSites& sites) const {
    if (averages()) return mean_model(sites);
    if (variogram_) return model_with(local(*variogram_, sites), sites);
    const auto [at, value] = measured(sites);
    return model_with(fit_variogram(at, value, {.models = kModels, .anisotropy = true, .drift = drift_}),
                      sites);
}

Variogram Kriging::variogram_of(const SiteField& field) const {
    if (variogram_) return *variogram_;
    const FieldSites sites = field_sites(holes().sites(), field);
    const auto [at, value] = measured(sites);
    Variogram v = averages()
                      ? mean_covariance(at, value, drift_).likeliest
                      : fit_variogram(at, value, {.models = kModels, .anisotropy = true, .drift = drift_});
    const double spread = value_scale(sites).spread;
    v.range /= sites.frame.xx;
    v.nugget *= spread * spread, v.sill *= spread * spread;
    return v;
}

}  // namespace stratareeb
