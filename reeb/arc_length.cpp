// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

constexpr int kMaxDepth = 24;  // cusps and pieces without length end here

//! Parts to start from, so that no bend between two samples is overlooked: a curve has no more bends than control points.
std::size_t first_parts(const Curve& curve) {
    if (curve.kind == CurveKind::Bezier) return std::max<std::size_t>(4, curve.points.size());
    return curve.kind == CurveKind::Nurbs ? std::max<std::size_t>(4, static_cast<std::size_t>(curve.degree))
                                          : 4;
}

//! The value at x of the line through the corners (from[i], to[i]).
double along(const std::vector<double>& from, const std::vector<double>& to, double x) {
    const auto after = std::upper_bound(from.begin() + 1, from.end() - 1, x);
    const auto i = static_cast<std::size_t>(after - from.begin());
    const double width = from[i] - from[i - 1];
    if (width == 0) return to[i];
    return to[i - 1] + (x - from[i - 1]) / width * (to[i] - to[i - 1]);
}

}  // namespace

ArcLength::ArcLength(const ParametricCurve& curve, double tolerance) {
    if (curve.curve().kind == CurveKind::Circle) {
        add(1, 2 * std::numbers::pi * curve.curve().radius);
        return;
    }
    const auto& joints = curve.joints();
    const bool straight = curve.curve().kind == CurveKind::Polyline;
    const std::size_t parts = straight ? 1 : first_parts(curve.curve());
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        if (straight) {
            add(joints[i + 1], magnitude(curve.cubic(i)[1]));
            continue;
        }
        const double width = joints[i + 1] - joints[i];
        for (std::size_t k = 0; k < parts; ++k) {
            const double from = joints[i] + width * static_cast<double>(k) / static_cast<double>(parts);
            const double to = joints[i] + width * static_cast<double>(k + 1) / static_cast<double>(parts);
            refine(curve, from, k + 1 == parts ? joints[i + 1] : to, tolerance, 0);
        }
    }
}

void ArcLength::add(double t, double length) {
    parameters_.push_back(t);
    lengths_.push_back(lengths_.back() + length);
}

void ArcLength::refine(const ParametricCurve& curve, double from, double to, double tolerance, int depth) {
    std::array<double, 5> t{};
    std::array<Point3, 5> p;
    for (std::size_t i = 0; i < 5; ++i) {
        t[i] = i == 4 ? to : from + (to - from) * static_cast<double>(i) / 4;
        p[i] = curve.at(t[i]);
    }
    double four = 0;
    for (std::size_t i = 0; i < 4; ++i) four += magnitude(p[i + 1] - p[i]);
    // Chords are short in proportion to the square of their step: four are short by 1/16 of what one is.
    const double missing = (four - magnitude(p[4] - p[0])) / 15;
    if (missing <= tolerance * four || depth == kMaxDepth) {
        for (std::size_t i = 0; i < 4; ++i) add(t[i + 1], magnitude(p[i + 1] - p[i]));
        error_ += std::max(0.0, missing);
        return;
    }
    refine(curve, from, t[2], tolerance, depth + 1);
    refine(curve, t[2], to, tolerance, depth + 1);
}

double ArcLength::parameter_at(double share) const {
    return length() > 0 ? std::clamp(along(lengths_, parameters_, share * length()), 0.0, 1.0) : share;
}

double ArcLength::share_at(double t) const {
    return length() > 0 ? std::clamp(along(parameters_, lengths_, t) / length(), 0.0, 1.0) : t;
}

SampledContour sample_contour(const Curve& curve, std::size_t count) {
    const ParametricCurve f(curve);
    if (!f.curve().closed) throw InvalidInput("contour: the curve is open (expected a closed one)");
    if (f.curve().kind == CurveKind::Polyline) return contour_by_perimeter(f.curve().points);
    if (count < 3)
        throw InvalidInput(fmt::format("contour: {} samples of a curve (expected at least 3)", count));
    const ArcLength length(f);
    SampledContour contour{{}, even_parameters(count)};
    for (const double s : contour.parameters) contour.points.push_back(f.at(length.parameter_at(s)));
    return contour;
}

}  // namespace stratareeb
