// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/continuous_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr double kSame =
    1e-12;  // parameters nearer than this are one; it is a rounding error, not a triangle

//! The parameters of both curves, ascending.
std::vector<double> common_parameters(const SampledCurve& upper, const SampledCurve& lower, bool closed) {
    std::vector<double> all;
    for (const SampledCurve* curve : {&upper, &lower})
        for (const double t : curve->parameters) {
            if (!std::isfinite(t) || (!closed && (t < 0 || t > 1)))
                throw InvalidInput(
                    fmt::format("a contour is to be sampled at parameter {}: expected 0 … 1", t));
            all.push_back(closed ? t - std::floor(t) : t);
        }
    if (all.empty()) throw InvalidInput("no parameters are given to sample the contours at");
    if (!closed) all.insert(all.end(), {0.0, 1.0});
    std::ranges::sort(all);
    std::vector<double> unique;
    for (const double t : all)
        if (unique.empty() || t - unique.back() > kSame) unique.push_back(t);
    if (closed && unique.size() > 1 && unique.front() + 1 - unique.back() <= kSame) unique.pop_back();
    if (!closed) unique.back() = 1;
    return unique;
}

}  // namespace

std::vector<std::array<double, 2>> ContinuousBand::path() const {
    std::vector<std::array<double, 2>> spans;
    std::size_t i = band.path.upper, j = band.path.lower;
    const auto parameter = [](const std::vector<double>& parameters, std::size_t index) {
        return parameters[index % parameters.size()] + static_cast<double>(index / parameters.size());
    };
    spans.push_back({parameter(upper_parameters, i), parameter(lower_parameters, j)});
    for (const bool upper_moves : band.path.upper_advances) {
        ++(upper_moves ? i : j);
        spans.push_back({parameter(upper_parameters, i), parameter(lower_parameters, j)});
    }
    return spans;
}

ContinuousBand continuous_band(const SampledCurve& upper, const SampledCurve& lower, BandOptions options) {
    ContinuousBand result;
    result.closed = options.closed;
    result.upper_parameters = result.lower_parameters = common_parameters(upper, lower, options.closed);
    for (const double t : result.upper_parameters) {
        result.upper.push_back(upper.at(t));
        result.lower.push_back(lower.at(t));
    }
    options.upper_parameters = result.upper_parameters;
    options.lower_parameters = result.lower_parameters;
    result.band = toroidal_band(result.upper, result.lower, options);
    return result;
}

}  // namespace stratareeb
