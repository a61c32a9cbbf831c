// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_slopes.h"

#include <cmath>
#include <cstddef>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

// Where a contour is seen almost along itself, tangent planes alone would ask for any slope: what the mean asks for gets this weight.
constexpr double kWeightOfMean = 0.001;

double cross_in_plan(const Point3& a, const Point3& b) {
    return a.x * b.y - a.y * b.x;
}
double dot_in_plan(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y;
}

//! Does each side turn the same way, seen from its targets?
bool is_seen_whole(std::span<const Point3> contour, std::span<const Point3> targets) {
    const std::size_t n = contour.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        if (!(cross_in_plan(contour[i] - targets[i], contour[next] - targets[i]) > 0) ||
            !(cross_in_plan(contour[i] - targets[next], contour[next] - targets[next]) > 0))
            return false;
    }
    return true;
}

}  // namespace

std::vector<double> cap_slopes(std::span<const Point3> contour, std::span<const Point3> targets,
                               std::span<const Point3> beside, double share) {
    const std::size_t n = contour.size();
    double growth = 0, square = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point3 arm = contour[i] - targets[i];
        growth += dot_in_plan(arm, beside[i] - contour[i]);
        square += dot_in_plan(arm, arm);
    }
    const double mean = square > 0 && share > 0 ? growth / square / share : 0;
    std::vector<double> slopes(n, mean);
    if (!(share > 0) || !is_seen_whole(contour, targets)) return slopes;
    for (std::size_t i = 0; i < n; ++i) {
        const Point3 along = contour[(i + 1) % n] - contour[(i + n - 1) % n], arm = contour[i] - targets[i];
        const double across_arm = cross_in_plan(arm, along),
                     across_move = cross_in_plan(beside[i] - contour[i], along),
                     of_mean = kWeightOfMean * dot_in_plan(arm, arm) * dot_in_plan(along, along);
        const double weight = across_arm * across_arm + of_mean;
        if (weight > 0) slopes[i] = (across_move * across_arm / share + of_mean * mean) / weight;
    }
    return slopes;
}

}  // namespace stratareeb
