// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/variogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr std::array<std::pair<VariogramModel, std::string_view>, 5> kNames{{
    {VariogramModel::Spherical, "spherical"},
    {VariogramModel::Exponential, "exponential"},
    {VariogramModel::Gaussian, "gaussian"},
    {VariogramModel::Matern32, "matern-3/2"},
    {VariogramModel::Matern52, "matern-5/2"},
}};
constexpr std::size_t kMostPairedSites = 2000;
constexpr int kRangesTried = 60;

struct LinearFit {
    double nugget, sill, misfit;
};

//! Least squares for γ = nugget + sill · rise, both ≥ 0.
LinearFit fit_sills(std::span<const VariogramBin> bins, VariogramModel model, double range) {
    double w = 0, wr = 0, wrr = 0, wg = 0, wrg = 0, wgg = 0;
    for (const VariogramBin& b : bins) {
        const double weight = b.pairs / std::max(b.gamma * b.gamma, 1e-300);
        const double rise = 1 - correlation(model, b.distance / range);
        w += weight, wr += weight * rise, wrr += weight * rise * rise;
        wg += weight * b.gamma, wrg += weight * rise * b.gamma, wgg += weight * b.gamma * b.gamma;
    }
    const double determinant = w * wrr - wr * wr;
    double nugget = 0, sill = wrr > 0 ? wrg / wrr : 0;
    if (determinant > 1e-12 * w * wrr) {
        const double n = (wrr * wg - wr * wrg) / determinant, s = (w * wrg - wr * wg) / determinant;
        if (n >= 0 && s >= 0) nugget = n, sill = s;
        if (s < 0) nugget = wg / w, sill = 0;
    }
    const double misfit = wgg - 2 * (nugget * wg + sill * wrg) + nugget * nugget * w +
                          2 * nugget * sill * wr + sill * sill * wrr;
    return {nugget, sill, misfit};
}

}  // namespace

std::string_view name_of(VariogramModel model) {
    return std::ranges::find(kNames, model, &std::pair<VariogramModel, std::string_view>::first)->second;
}

VariogramModel variogram_model(std::string_view name) {
    for (const auto& [model, known] : kNames)
        if (name == known) return model;
    throw InvalidInput("unknown variogram model '" + std::string(name) +
                       "' (expected spherical, exponential, gaussian, matern-3/2 or matern-5/2)");
}

double correlation(VariogramModel model, double t) {
    switch (model) {
        case VariogramModel::Spherical:
            return t < 1 ? 1 - 1.5 * t + 0.5 * t * t * t : 0;
        case VariogramModel::Exponential:
            return std::exp(-kPracticalExponential * t);
        case VariogramModel::Gaussian:
            return std::exp(-kPracticalExponential * t * t);
        case VariogramModel::Matern32: {
            const double s = kPracticalMatern32 * t;
            return (1 + s) * std::exp(-s);
        }
        case VariogramModel::Matern52: {
            const double s = kPracticalMatern52 * t;
            return (1 + s + s * s / 3) * std::exp(-s);
        }
    }
    return 0;
}

double Variogram::at(double distance) const {
    return distance > 0 ? nugget + sill * (1 - correlation(model, distance / range)) : 0;
}

double Variogram::at(double dx, double dy) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return at(std::hypot(c * dx + s * dy, (c * dy - s * dx) / ratio));
}

std::vector<VariogramBin> experimental_variogram(std::span<const Point2> at, std::span<const double> value,
                                                 double reach, std::size_t bins) {
    std::vector<VariogramBin> sums(bins);
    const std::size_t step = at.size() / kMostPairedSites + 1;
    for (std::size_t i = 0; i < at.size(); i += step)
        for (std::size_t j = i + step; j < at.size(); j += step) {
            const double h = std::hypot(at[i].x - at[j].x, at[i].y - at[j].y);
            if (h >= reach) continue;
            const double d = value[i] - value[j];
            VariogramBin& bin =
                sums[std::min(static_cast<std::size_t>(h / reach * static_cast<double>(bins)), bins - 1)];
            bin.distance += h, bin.gamma += d * d / 2, bin.pairs += 1;
        }
    std::erase_if(sums, [](const VariogramBin& b) { return b.pairs == 0; });
    for (VariogramBin& b : sums) b.distance /= b.pairs, b.gamma /= b.pairs;
    return sums;
}

Variogram fit_to_bins(std::span<const VariogramBin> bins, VariogramModel model) {
    double farthest = 0, highest = 0;
    for (const VariogramBin& b : bins)
        farthest = std::max(farthest, b.distance), highest = std::max(highest, b.gamma);
    if (farthest == 0) return {.model = model, .nugget = 0, .sill = std::max(highest, 1e-300), .range = 1};
    if (bins.size() < 3) return {.model = model, .nugget = 0, .sill = highest, .range = farthest};
    Variogram best{.model = model};
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kRangesTried; ++k) {
        const double range = farthest * std::pow(10.0, -1.5 + 2.0 * k / kRangesTried);
        const LinearFit fit = fit_sills(bins, model, range);
        if (fit.misfit >= least) continue;
        least = fit.misfit;
        best.nugget = fit.nugget, best.sill = fit.sill, best.range = range;
    }
    return best;
}

}  // namespace stratareeb
