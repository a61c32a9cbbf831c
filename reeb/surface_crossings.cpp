// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_crossings.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stratareeb {

namespace {

constexpr double kMostLogarithm = 60;  // of the stretch: heights stay far from what a double can't hold

//! Of what is above 0; 0 if nothing is.
double median(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !(value > 0); });
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

double stretch_of(const TriangleSoup& soup) {
    std::vector<double> widths, rises;
    for (const auto& [i, j, k] : soup.triangles) {
        const Point3 &a = soup.points[i], &b = soup.points[j], &c = soup.points[k];
        const auto extent = [&](double Point3::*axis) {
            return std::max({a.*axis, b.*axis, c.*axis}) - std::min({a.*axis, b.*axis, c.*axis});
        };
        widths.push_back(std::max(extent(&Point3::x), extent(&Point3::y)));
        rises.push_back(extent(&Point3::z));
    }
    const double width = median(std::move(widths)), rise = median(std::move(rises));
    if (!(width > 0 && rise > 0)) return 1;
    return std::exp2(std::clamp(std::round(std::log2(width / rise)), 0.0, kMostLogarithm));
}

}  // namespace

SelfIntersections surface_crossings(const TriangleSoup& soup, std::size_t named) {
    TriangleSoup stretched = soup;
    const double stretch = stretch_of(soup);
    for (Point3& p : stretched.points) p.z *= stretch;
    return self_intersections(stretched, named);
}

}  // namespace stratareeb
