// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/plane_frame.h"
#include "reeb/point_math.h"
#include "reeb/prepared_curve.h"
#include "reeb/spline_basis.h"

namespace stratareeb {
namespace {

constexpr double kClosedTolerance =
    1e-9;  // of the control points' extent: the gap a closed NURBS curve may have

std::vector<double> even_joints(std::size_t pieces) {
    std::vector<double> joints;
    for (std::size_t i = 0; i < pieces; ++i) {
        joints.push_back(static_cast<double>(i) / static_cast<double>(pieces));
    }
    joints.push_back(1);
    return joints;
}

std::vector<double> joints_of(const Curve& curve) {
    if (curve.kind == CurveKind::Circle || curve.kind == CurveKind::Bezier) return {0, 1};
    if (curve.kind != CurveKind::Nurbs) return even_joints(curve.points.size() - (curve.closed ? 0 : 1));
    const auto degree = static_cast<std::size_t>(curve.degree);
    const double start = curve.knots[degree], end = curve.knots[curve.points.size()];
    std::vector<double> joints{0};
    for (std::size_t i = degree; i <= curve.points.size(); ++i) {
        const double t = (curve.knots[i] - start) / (end - start);
        if (t > joints.back()) joints.push_back(t);
    }
    joints.back() = 1;
    return joints;
}

Point3 circle_value(const Curve& curve, double t, bool derived) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const PlaneFrame frame = plane_frame(curve.normal);
    const double c = curve.radius * std::cos(kTurn * t), s = curve.radius * std::sin(kTurn * t);
    if (derived) return kTurn * (c * frame.v - s * frame.u);
    return curve.center + (c * frame.u + s * frame.v);
}

Point3 bezier_value(const Curve& curve, double t, bool derived) {
    const auto& p = curve.points;
    const std::size_t degree = p.size() - 1;
    const auto basis = bernstein_basis(degree - (derived ? 1 : 0), t);
    Point3 sum;
    for (std::size_t k = 0; k < basis.size(); ++k) {
        sum += derived ? static_cast<double>(degree) * basis[k] * (p[k + 1] - p[k]) : basis[k] * p[k];
    }
    return sum;
}

Point3 nurbs_value(const Curve& curve, double t, bool derived) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    const double start = curve.knots[degree], end = curve.knots[curve.points.size()];
    const double x = t == 1 ? end : std::clamp(start + t * (end - start), start, end);
    const auto basis = bspline_basis(curve.knots, degree, x);
    Point3 sum, sum_slope;
    double weight = 0, weight_slope = 0;
    for (std::size_t r = 0; r <= degree; ++r) {
        const std::size_t i = basis.first + r;
        if (basis.values[r] == 1 && !derived) return curve.points[i];  // w p / w need not be p
        const double w = curve.weights.empty() ? 1 : curve.weights[i];
        sum += w * basis.values[r] * curve.points[i];
        sum_slope += w * basis.slopes[r] * curve.points[i];
        weight += w * basis.values[r];
        weight_slope += w * basis.slopes[r];
    }
    const Point3 value = (1 / weight) * sum;
    if (!derived) return value;
    return ((end - start) / weight) * (sum_slope - weight_slope * value);
}

Point3 cubic_value(const std::array<Point3, 4>& c, double u) {
    return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
}

Point3 cubic_slope(const std::array<Point3, 4>& c, double u) {
    return c[1] + u * (2 * c[2] + (3 * u) * c[3]);
}

}  // namespace

std::string_view curve_name(CurveKind kind, bool closed) {
    switch (kind) {
        case CurveKind::Polyline:
            return closed ? "polygon" : "line";
        case CurveKind::Circle:
            return "circle";
        case CurveKind::Bezier:
            return "bezier";
        case CurveKind::Nurbs:
            return "nurbs";
        case CurveKind::Cardinal:
            return "cardinal";
        case CurveKind::CatmullRom:
            return "catmull-rom";
    }
    return "unknown";
}

std::optional<CurveKind> curve_kind(std::string_view name) {
    if (name == "polygon" || name == "line" || name == "polyline") return CurveKind::Polyline;
    for (int i = 1; i <= static_cast<int>(CurveKind::CatmullRom); ++i) {
        const auto kind = static_cast<CurveKind>(i);
        if (name == curve_name(kind, true)) return kind;
    }
    return std::nullopt;
}

ParametricCurve::ParametricCurve(Curve curve)
    : curve_(prepared_curve(std::move(curve))), joints_(joints_of(curve_)) {
    if (curve_.kind != CurveKind::Nurbs || !curve_.closed) return;
    double extent = 0;
    for (const auto& p : curve_.points) extent = std::max(extent, magnitude(p - curve_.points[0]));
    const double gap = magnitude(value(1, false) - value(0, false));
    if (gap > kClosedTolerance * extent) {
        throw InvalidInput(
            fmt::format("{} curve: it is said to be closed, but its ends are {} apart (give no knots for a "
                        "periodic curve, or repeat the first point)",
                        curve_name(curve_.kind, true), gap));
    }
}

//! The points around, a closed curve's over and over.
const Point3& ParametricCurve::point(std::ptrdiff_t i) const {
    const auto size = static_cast<std::ptrdiff_t>(curve_.points.size());
    return curve_.points[static_cast<std::size_t>(((i % size) + size) % size)];
}

//! The points with those that an open spline lacks before its first and after its last.
Point3 ParametricCurve::control(std::ptrdiff_t i) const {
    const auto size = static_cast<std::ptrdiff_t>(curve_.points.size());
    if (!curve_.closed && i < 0) return 2 * point(0) - point(1);
    if (!curve_.closed && i >= size) return 2 * point(size - 1) - point(size - 2);
    return point(i);
}

std::array<Point3, 4> ParametricCurve::cubic(std::size_t i) const {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const Point3& p = point(at);
    const Point3& q = point(at + 1);
    const Point3 chord = q - p;
    if (curve_.kind == CurveKind::Polyline) return {p, chord, {}, {}};
    assert(curve_.kind == CurveKind::Cardinal || curve_.kind == CurveKind::CatmullRom);
    const Point3 before = control(at - 1), after = control(at + 2);
    Point3 start, end;
    if (curve_.kind == CurveKind::Cardinal) {
        start = curve_.tension * (q - before);
        end = curve_.tension * (after - p);
    } else {
        start = (1 - curve_.a) * (p - before) + curve_.a * chord;
        end = (1 - curve_.b) * chord + curve_.b * (after - q);
    }
    return {p, start, 3 * chord - 2 * start - end, start + end - 2 * chord};
}

Point3 ParametricCurve::value(double t, bool derived) const {
    switch (curve_.kind) {
        case CurveKind::Circle:
            return circle_value(curve_, t, derived);
        case CurveKind::Bezier:
            return bezier_value(curve_, t, derived);
        case CurveKind::Nurbs:
            return nurbs_value(curve_, t, derived);
        default:
            break;
    }
    const auto count = static_cast<double>(pieces());
    const auto i = std::min(pieces() - 1, static_cast<std::size_t>(t * count));
    const double u = t * count - static_cast<double>(i);
    if (derived) return count * cubic_slope(cubic(i), u);
    return u == 1 ? point(static_cast<std::ptrdiff_t>(i) + 1) : cubic_value(cubic(i), u);
}

namespace {

double parameter_inside(double t, bool closed) {
    if (std::isnan(t)) throw InvalidInput("curve: the parameter is not a number");
    if (t >= 0 && t <= 1) return t;
    return closed && std::isfinite(t) ? t - std::floor(t) : std::clamp(t, 0.0, 1.0);
}

}  // namespace

Point3 ParametricCurve::at(double t) const {
    const double inside = parameter_inside(t, curve_.closed);
    // A closed curve's end is its start, to the last bit.
    return value(curve_.closed && inside == 1 ? 0 : inside, false);
}

Point3 ParametricCurve::derivative(double t) const {
    const double inside = parameter_inside(t, curve_.closed);
    return value(curve_.closed && inside == 1 ? 0 : inside, true);
}

}  // namespace stratareeb
