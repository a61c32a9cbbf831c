// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/site_gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

double median_gap(std::span<const Point2> at) {
    const NearestSites index(at);
    std::vector<double> gaps;
    std::vector<NearSite> near;
    const std::size_t step = at.size() / 1000 + 1;
    for (std::size_t i = 0; i < at.size(); i += step) {
        index.nearest(at[i], 2, near);
        if (near.size() == 2) gaps.push_back(std::sqrt(near[1].squared_distance));
    }
    if (gaps.empty()) return 1;
    std::ranges::nth_element(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2));
    return gaps[gaps.size() / 2];
}

double extent_of(std::span<const Point2> at) {
    const double n = static_cast<double>(at.size());
    Point2 middle;
    for (const Point2& p : at) middle.x += (p.x - at[0].x) / n, middle.y += (p.y - at[0].y) / n;
    double sum = 0;
    for (const Point2& p : at) {
        const double dx = p.x - at[0].x - middle.x, dy = p.y - at[0].y - middle.y;
        sum += (dx * dx + dy * dy) / n;
    }
    return 2 * std::sqrt(3 * sum);
}

}  // namespace stratareeb
