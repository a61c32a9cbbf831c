// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/band_count.h"

#include <algorithm>
#include <cmath>

#include "reeb/correspondence.h"
#include "reeb/point_math.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

namespace {

constexpr double kLowestBand = 3;  // of the spacing over the steps
constexpr std::size_t kFewPoints = 96;
constexpr double kShareOfWidth = 1.0 / 6;  // of a contour, which is twice its area over its length

}  // namespace

double point_spacing(std::span<const Point3> contour) {
    const double length = perimeter(contour),
                 spacing = length / static_cast<double>(std::max(contour.size(), kFewPoints));
    return length > 0 ? std::min(spacing, kShareOfWidth * magnitude(area_vector(contour)) / length) : 0;
}

std::size_t bands_across(double gap, double spacing, std::size_t steps, std::size_t least, std::size_t most) {
    const double lowest = kLowestBand / static_cast<double>(steps) * spacing;
    if (!(gap < lowest * static_cast<double>(most))) return std::max(least, most);
    return std::max(least, static_cast<std::size_t>(std::ceil(gap / lowest)));
}

}  // namespace stratareeb
