// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thin_plate_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boreholes/blended_surface.h"
#include "boreholes/errors.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

constexpr std::array kTensions{0.0, 0.5, 1.0, 2.0, 5.0, 10.0};  // per mean gap
constexpr std::array kSmoothings{0.0, 1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0};
// The side of the square that each of many sites scattered evenly at random has to itself, over their median distance.
constexpr double kEvenGap = 2.13;
constexpr double kWorth = 1e-3;  // a stiffer choice must be better by this share

// The kernel times 1 / gap² has size one between neighbours, so that the diagonal is in shares of that.
RadialModel radial_model(double tension_per_gap, double smoothing, double gap) {
    return {spline_kernel(tension_per_gap / gap), 1, smoothing * gap * gap};
}

}  // namespace

ThinPlateSpline::ThinPlateSpline(std::shared_ptr<const HoleTriangulation> holes,
                                 const InterpolatorOptions& options)
    : RadialInterpolator(std::move(holes), options.single_patch),
      tension_(options.tension),
      smoothing_(options.smoothing),
      smoothing_by_data_(options.smoothing_by_data) {
    if (!(tension_.value_or(0) >= 0) || !(smoothing_ >= 0))
        throw InvalidInput("a spline needs a tension and a smoothing of at least 0");
}

ThinPlateSpline::FieldModel ThinPlateSpline::model_of(const FieldSites& sites) const {
    const double gap = kEvenGap * median_gap(sites.at);
    FieldModel result;
    result.frame = sites.frame;
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](double tension, double smoothing) {
        RadialModel model = radial_model(tension, smoothing, gap);
        const double error = BlendedSurface(sites, model, {.single = 150}).leave_one_out_rms();
        if (error >= best * (1 - kWorth) && result.radial.kernel) return;
        best = error;
        result.radial = std::move(model);
    };
    for (const double tension : kTensions) {
        if (tension_ && tension != kTensions[0]) break;
        for (const double smoothing : kSmoothings) {
            if (!smoothing_by_data_ && smoothing != kSmoothings[0]) break;
            consider(tension_.value_or(tension), smoothing_by_data_ ? smoothing : smoothing_);
        }
    }
    result.honours_values = result.radial.diagonal == 0;
    result.variance_factor = BlendedSurface(sites, result.radial, cover()).energy_per_freedom();
    return result;
}

}  // namespace stratareeb
