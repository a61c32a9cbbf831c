// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/prepared_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boreholes/errors.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

constexpr int kMaxDegree = 100;

[[noreturn]] void refuse(const Curve& curve, const std::string& why) {
    throw InvalidInput(fmt::format("{} curve: {}", curve_name(curve.kind, curve.closed), why));
}

void check_circle(const Curve& curve) {
    if (!is_finite(curve.center) || !is_finite(curve.normal)) {
        refuse(curve, "center and normal must be finite numbers");
    }
    if (!(curve.radius > 0) || !std::isfinite(curve.radius)) {
        refuse(curve, fmt::format("radius {} (expected a number above 0)", curve.radius));
    }
    if (magnitude(curve.normal) == 0) refuse(curve, "normal 0, 0, 0 has no direction");
}

std::size_t fewest_points(const Curve& curve) {
    if (curve.kind == CurveKind::Nurbs) return static_cast<std::size_t>(curve.degree) + 1;
    return curve.closed ? 3 : 2;
}

void check_points(const Curve& curve) {
    const std::size_t fewest = fewest_points(curve);
    if (curve.points.size() < fewest) {
        refuse(curve, fmt::format("{} points (expected at least {})", curve.points.size(), fewest));
    }
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        if (!is_finite(curve.points[i])) {
            refuse(curve, fmt::format("point {} has a coordinate that is not a finite number", i));
        }
    }
}

void check_weights(const Curve& curve) {
    if (!curve.weights.empty() && curve.weights.size() != curve.points.size()) {
        refuse(curve, fmt::format("{} weights for {} points (expected one each, or none)",
                                  curve.weights.size(), curve.points.size()));
    }
    for (std::size_t i = 0; i < curve.weights.size(); ++i) {
        if (!(curve.weights[i] > 0) || !std::isfinite(curve.weights[i])) {
            refuse(curve,
                   fmt::format("weight {} of point {} (expected a number above 0)", curve.weights[i], i));
        }
    }
}

void check_knots(const Curve& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    const std::size_t expected = curve.points.size() + degree + 1;
    if (curve.knots.size() != expected) {
        refuse(curve,
               fmt::format("{} knots for {} points of degree {} (expected {}, or none for uniform ones)",
                           curve.knots.size(), curve.points.size(), curve.degree, expected));
    }
    for (std::size_t i = 0; i < expected; ++i) {
        if (!std::isfinite(curve.knots[i]) || (i > 0 && curve.knots[i] < curve.knots[i - 1])) {
            refuse(curve,
                   fmt::format("knot {} is {} (expected finite numbers that don't fall)", i, curve.knots[i]));
        }
        if (i > degree && curve.knots[i] == curve.knots[i - degree] && curve.knots[i] > curve.knots[degree] &&
            curve.knots[i] < curve.knots[expected - 1 - degree]) {
            refuse(curve, fmt::format("knot {} occurs more than {} times: the curve would be broken there",
                                      curve.knots[i], curve.degree));
        }
    }
    if (!(curve.knots[degree] < curve.knots[expected - 1 - degree])) {
        refuse(curve, fmt::format("knots {} to {} leave no range", degree, expected - 1 - degree));
    }
}

//! Knots clamped at both ends, even between: the curve starts at its first control point and ends at its last.
std::vector<double> clamped_knots(std::size_t points, std::size_t degree) {
    std::vector<double> knots(points + degree + 1, 0.0);
    const auto spans = static_cast<double>(points - degree);
    for (std::size_t i = degree + 1; i < knots.size(); ++i) {
        knots[i] = std::min(static_cast<double>(i - degree), spans);
    }
    return knots;
}

//! Make a closed curve of control points periodic: the first `degree` stand again at the end, with even knots.
void make_periodic(Curve& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    const std::size_t size = curve.points.size();
    for (std::size_t i = 0; i < degree; ++i) {
        curve.points.push_back(curve.points[i % size]);
        if (!curve.weights.empty()) curve.weights.push_back(curve.weights[i % size]);
    }
    curve.knots.resize(curve.points.size() + degree + 1);
    for (std::size_t i = 0; i < curve.knots.size(); ++i) curve.knots[i] = static_cast<double>(i);
}

void drop_repeated_start(Curve& curve) {
    if (!curve.closed || curve.points.size() < 2 || curve.points.front() != curve.points.back()) return;
    if (curve.kind == CurveKind::Nurbs && !curve.knots.empty()) return;
    curve.points.pop_back();
    if (curve.weights.size() > curve.points.size()) curve.weights.pop_back();
}

void prepare_nurbs(Curve& curve) {
    check_weights(curve);
    if (curve.knots.empty()) {
        if (curve.closed) {
            make_periodic(curve);
        } else {
            curve.knots = clamped_knots(curve.points.size(), static_cast<std::size_t>(curve.degree));
        }
    }
    check_knots(curve);
}

}  // namespace

Curve prepared_curve(Curve curve) {
    if (curve.kind == CurveKind::Circle) {
        curve.closed = true;
        check_circle(curve);
        return curve;
    }
    if (curve.kind == CurveKind::Nurbs && (curve.degree < 1 || curve.degree > kMaxDegree)) {
        refuse(curve, fmt::format("degree {} (expected 1 to {})", curve.degree, kMaxDegree));
    }
    drop_repeated_start(curve);
    check_points(curve);
    if (curve.kind == CurveKind::Nurbs) prepare_nurbs(curve);
    if (curve.kind == CurveKind::Bezier && curve.closed) curve.points.push_back(curve.points.front());
    const bool is_cardinal = curve.kind == CurveKind::Cardinal && std::isfinite(curve.tension);
    const bool is_catmull_rom =
        curve.kind == CurveKind::CatmullRom && std::isfinite(curve.a) && std::isfinite(curve.b);
    if (curve.kind >= CurveKind::Cardinal && !is_cardinal && !is_catmull_rom) {
        refuse(curve, "tension, a and b must be finite numbers");
    }
    return curve;
}

}  // namespace stratareeb
