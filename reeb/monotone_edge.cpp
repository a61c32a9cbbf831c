// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/monotone_edge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();  // of the largest |z|

using Cubic = std::array<double, 4>;  // c0 + c1 u + c2 u^2 + c3 u^3

Cubic heights(const ParametricCurve& curve, std::size_t piece) {
    const auto c = curve.cubic(piece);
    return {c[0].z, c[1].z, c[2].z, c[3].z};
}

//! The rise from a to b, without taking the difference of two heights.
double rise(const Cubic& c, double a, double b) {
    return (b - a) * (c[1] + c[2] * (a + b) + c[3] * (a * a + a * b + b * b));
}

//! 0, the places in (0, 1) where the slope changes its sign, 1, ascending.
std::vector<double> turning_places(const Cubic& c) {
    std::vector<double> places{0, 1};
    const auto add = [&](double u) {
        if (u > 0 && u < 1) places.push_back(u);
    };
    const double a = 3 * c[3], half_b = c[2], slope = c[1];  // a u^2 + 2 half_b u + slope
    const double discriminant = half_b * half_b - a * slope;
    if (discriminant > 0) {
        const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));  // nothing cancels
        add(slope / q);
        if (a != 0) add(q / a);
    }
    std::sort(places.begin(), places.end());
    return places;
}

double largest_height(const ParametricCurve& curve) {
    double largest = 0;
    for (const auto& p : curve.curve().points) largest = std::max(largest, std::abs(p.z));
    return largest;
}

void check_kind(const Curve& curve) {
    const bool spline = curve.kind == CurveKind::Polyline || curve.kind == CurveKind::Cardinal ||
                        curve.kind == CurveKind::CatmullRom;
    if (spline && !curve.closed) return;
    throw InvalidInput(fmt::format("edge: a {}{} curve (expected an open line, cardinal or catmull-rom)",
                                   curve.closed ? "closed " : "", curve_name(curve.kind, curve.closed)));
}

double turned(double z, bool rising) {
    return rising ? z : -z;
}

}  // namespace

ZMonotonicity z_monotonicity(const ParametricCurve& curve) {
    check_kind(curve.curve());
    const double tolerance = kRounding * largest_height(curve);
    const double whole = curve.at(1).z - curve.at(0).z;
    ZMonotonicity result;
    result.direction = whole > 0 ? 1 : whole < 0 ? -1 : 0;
    const int sign = result.direction == 0 ? 1 : result.direction;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Cubic c = heights(curve, i);
        const bool level = std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]) <= tolerance;
        const auto places = level ? std::vector<double>{0, 1} : turning_places(c);
        for (std::size_t k = 0; k + 1 < places.size(); ++k) {
            if (!level && sign * rise(c, places[k], places[k + 1]) >= -tolerance) continue;
            const double start = curve.joints()[i], width = curve.joints()[i + 1] - start;
            result.from = start + width * places[k];
            result.to = start + width * places[k + 1];
            result.from_z = c[0] + rise(c, 0, places[k]);
            result.to_z = c[0] + rise(c, 0, places[k + 1]);
            return result;
        }
    }
    result.monotone = result.direction != 0;
    return result;
}

MonotoneEdge::MonotoneEdge(const Curve& curve) : curve_(curve) {
    const auto found = z_monotonicity(curve_);
    if (!found.monotone) {
        throw InvalidInput(
            fmt::format("edge: {} from z = {} to {} between t = {:.6g} and {:.6g} (expected z to rise all "
                        "the way, or to fall)",
                        found.from_z == found.to_z ? "it runs level" : "it turns back", found.from_z,
                        found.to_z, found.from, found.to));
    }
    rising_ = found.direction > 0;
    for (std::size_t i = 0; i < curve_.pieces(); ++i)
        heights_.push_back(turned(curve_.cubic(i)[0].z, rising_));
    heights_.push_back(turned(curve_.at(1).z, rising_));
}

double MonotoneEdge::parameter_at(double z) const {
    if (!(z >= lowest() && z <= highest())) {
        throw InvalidInput(
            fmt::format("edge: no point at z = {} (it runs from {} to {})", z, lowest(), highest()));
    }
    const double goal = turned(z, rising_);
    const auto& joints = curve_.joints();
    const auto joint = std::lower_bound(heights_.begin(), heights_.end(), goal);
    const auto next = static_cast<std::size_t>(joint - heights_.begin());
    if (*joint == goal) return joints[next];
    const std::size_t i = next - 1;
    const Cubic c = heights(curve_, i);
    double low = 0, high = 1;
    while (true) {  // halve until two doubles are neighbours: slow and sure, flat places included
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        (turned(c[0] + rise(c, 0, middle), rising_) <= goal ? low : high) = middle;
    }
    return joints[i] + low * (joints[i + 1] - joints[i]);
}

Point3 MonotoneEdge::at(double z) const {
    Point3 p = curve_.at(parameter_at(z));
    p.z = z;
    return p;
}

}  // namespace stratareeb
