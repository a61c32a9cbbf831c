// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/edge_distance.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

constexpr int kSamplesASpan = 10;

}  // namespace

double distance_within_span(const SplineCurve& curve, std::size_t span, const HeightPatch& sheet) {
    const auto& breaks = curve.knots.breaks();
    double distance = 0;
    for (int k = 0; k <= kSamplesASpan; ++k) {
        const double t = std::lerp(breaks[span], breaks[span + 1], k / double(kSamplesASpan));
        distance = std::max(distance, std::abs(curve.at(2, t) - sheet.z({curve.at(0, t), curve.at(1, t)})));
    }
    return distance;
}

}  // namespace stratareeb
