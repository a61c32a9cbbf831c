// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/interpolator.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "boreholes/errors.h"
#include "boreholes/inverse_distance.h"
#include "boreholes/kriging.h"
#include "boreholes/linear_tin.h"
#include "boreholes/minimum_curvature.h"
#include "boreholes/natural_neighbour.h"
#include "boreholes/sibson_c0.h"
#include "boreholes/thin_plate_spline.h"

namespace stratareeb {

namespace {

constexpr std::array kKinds{InterpolatorKind::Linear,          InterpolatorKind::NaturalNeighbour,
                            InterpolatorKind::SibsonC0,        InterpolatorKind::InverseDistance,
                            InterpolatorKind::Spline,          InterpolatorKind::MinimumCurvature,
                            InterpolatorKind::Kriging,         InterpolatorKind::KrigingLinear,
                            InterpolatorKind::KrigingQuadratic};
constexpr std::array<std::string_view, kKinds.size()> kNames{
    "linear",  "natural",        "sibson-c0",        "inverse-distance", "spline", "minimum-curvature",
    "kriging", "kriging-linear", "kriging-quadratic"};

}  // namespace

std::vector<FieldPrediction> Interpolator::predict_with_deviation(std::span<const Point2> where,
                                                                  std::span<const SiteField> fields) const {
    std::vector<FieldPrediction> result;
    for (auto& value : predict(where, fields)) result.push_back({std::move(value), {}});
    return result;
}

bool takes_bounds(InterpolatorKind kind) {
    switch (kind) {
        case InterpolatorKind::Spline:
        case InterpolatorKind::Kriging:
        case InterpolatorKind::KrigingLinear:
        case InterpolatorKind::KrigingQuadratic:
            return true;
        default:
            return false;
    }
}

std::span<const InterpolatorKind> interpolator_kinds() {
    return kKinds;
}

std::string_view name_of(InterpolatorKind kind) {
    return kNames[static_cast<std::size_t>(std::ranges::find(kKinds, kind) - kKinds.begin())];
}

std::string interpolator_names() {
    std::string result;
    for (std::size_t k = 0; k < kNames.size(); ++k) {
        if (k > 0) result += k + 1 < kNames.size() ? ", " : " or ";
        result += kNames[k];
    }
    return result;
}

InterpolatorKind interpolator_kind(std::string_view name) {
    for (std::size_t k = 0; k < kNames.size(); ++k)
        if (name == kNames[k]) return kKinds[k];
    throw InvalidInput("unknown interpolator '" + std::string(name) + "' (expected " + interpolator_names() +
                       ")");
}

std::unique_ptr<Interpolator> make_interpolator(InterpolatorKind kind,
                                                std::shared_ptr<const HoleTriangulation> holes,
                                                const InterpolatorOptions& options) {
    switch (kind) {
        case InterpolatorKind::Linear:
            return std::make_unique<LinearTin>(std::move(holes));
        case InterpolatorKind::NaturalNeighbour:
            return std::make_unique<NaturalNeighbour>(std::move(holes));
        case InterpolatorKind::SibsonC0:
            return std::make_unique<SibsonC0>(std::move(holes));
        case InterpolatorKind::InverseDistance:
            return std::make_unique<InverseDistance>(std::move(holes), options);
        case InterpolatorKind::Spline:
            return std::make_unique<ThinPlateSpline>(std::move(holes), options);
        case InterpolatorKind::MinimumCurvature:
            return std::make_unique<MinimumCurvature>(std::move(holes), options);
        case InterpolatorKind::Kriging:
            return std::make_unique<Kriging>(std::move(holes), 0, options);
        case InterpolatorKind::KrigingLinear:
            return std::make_unique<Kriging>(std::move(holes), 1, options);
        case InterpolatorKind::KrigingQuadratic:
            return std::make_unique<Kriging>(std::move(holes), 2, options);
    }
    throw InvalidInput("unknown interpolator");
}

}  // namespace stratareeb
