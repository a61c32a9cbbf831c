// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/correspondence.h"

#include <algorithm>
#include <cmath>

#include "reeb/closest_pair.h"
#include "reeb/plane_frame.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

constexpr double kFlat = 1e-12;     // area against squared extent: below it a contour has no plane of its own
constexpr double kVertical = 1e-9;  // of the normal's length: below it a component is 0

//! The contour's unit normal; up for a contour without a plane of its own.
Point3 unit_normal(std::span<const Point3> points) {
    double extent = 0;
    for (const Point3& p : points) extent = std::max(extent, magnitude(p - points[0]));
    const Point3 area = area_vector(points);
    const double size = magnitude(area);
    return size > kFlat * extent * extent ? (1 / size) * area : Point3{0, 0, 1};
}

//! A normal or its opposite, so that clockwise contours are seen from the same side as others: the side where z is larger;
//! for vertical planes y, then x.
Point3 upper_side(const Point3& normal) {
    for (const double component : {normal.z, normal.y, normal.x}) {
        if (std::abs(component) > kVertical) return component > 0 ? normal : -1 * normal;
    }
    return normal;
}

//! Points in their own plane, turned level. Measured from the box's corner: the same whichever point is first.
std::vector<Point2> levelled(std::span<const Point3> points, const PlaneFrame& frame) {
    Point3 low = points[0];
    for (const Point3& p : points) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    std::vector<Point2> result;
    for (const Point3& p : points) {
        const Point3 q = frame.turned(p - low);
        result.push_back({q.x, q.y});
    }
    return result;
}

struct Moments {
    double xx = 0, xy = 0, yy = 0;
};

//! Second moments of a closed polyline's sides about its centre, in shares of their sum: each contour counts alike.
Moments moments(std::span<const Point2> ring) {
    double length = 0, x = 0, y = 0;
    const auto each_side = [&](auto&& use) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            use(a, b, std::hypot(b.x - a.x, b.y - a.y));
        }
    };
    each_side([&](const Point2& a, const Point2& b, double side) {
        length += side;
        x += side * (a.x + b.x) / 2;
        y += side * (a.y + b.y) / 2;
    });
    if (length == 0) return {};
    const Point2 center{x / length, y / length};
    Moments m;
    each_side([&](const Point2& a, const Point2& b, double side) {
        const double ax = a.x - center.x, ay = a.y - center.y, bx = b.x - center.x, by = b.y - center.y;
        m.xx += side * (ax * ax + ax * bx + bx * bx);  // three times the integral along the side
        m.xy += side * (ax * ay + bx * by + (ax * by + ay * bx) / 2);
        m.yy += side * (ay * ay + ay * by + by * by);
    });
    const double sum = m.xx + m.yy;
    return {m.xx / sum, m.xy / sum, m.yy / sum};
}

void turn(std::vector<Point2>& points, double cosine, double sine) {
    for (Point2& p : points) p = {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x};
}

void turn_to_principal_axes(std::vector<Point2>& first, std::vector<Point2>& second) {
    const Moments a = moments(first), b = moments(second);
    const double angle = 0.5 * std::atan2(2 * (a.xy + b.xy), (a.xx + b.xx) - (a.yy + b.yy));
    turn(first, std::cos(angle), std::sin(angle));
    turn(second, std::cos(angle), std::sin(angle));
}

void fit_to_unit_square(std::vector<Point2>& points) {
    Point2 low = points[0], high = points[0];
    for (const Point2& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto fit = [](double x, double from, double to) {
        return to > from ? (x - from) / (to - from) : 0.5;
    };
    for (Point2& p : points) p = {fit(p.x, low.x, high.x), fit(p.y, low.y, high.y)};
}

SampledContour sampled(const SampledContour& contour, std::size_t samples) {
    if (samples == 0) return contour;
    auto s = even_parameters(samples);
    auto points = points_at(contour, s);
    return {std::move(points), std::move(s)};
}

}  // namespace

Point3 area_vector(std::span<const Point3> points) {
    Point3 sum;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        sum += cross_product(points[i] - points[0], points[i + 1] - points[0]);
    }
    return sum;
}

Correspondence correspond(const SampledContour& first, const SampledContour& second,
                          const CorrespondenceOptions& options) {
    check_contour(first);
    check_contour(second);
    const auto f = sampled(first, options.samples), g = sampled(second, options.samples);
    const auto answer = [&](const ClosestPair& pair) {
        return Correspondence{f.parameters[pair.first], g.parameters[pair.second], pair.distance};
    };
    if (options.distance == ContourDistance::Parametric) {
        return answer(closest_parameters(f.parameters, g.parameters));
    }
    const Point3 f_normal = upper_side(unit_normal(f.points)), g_normal = unit_normal(g.points);
    const bool same_side = dot_product(f_normal, g_normal) >= 0;
    auto f_image = levelled(f.points, plane_frame(f_normal));
    auto g_image = levelled(g.points, plane_frame(same_side ? g_normal : -1 * g_normal));
    if (options.axes == RectangleAxes::Principal) turn_to_principal_axes(f_image, g_image);
    fit_to_unit_square(f_image);
    fit_to_unit_square(g_image);
    return answer(closest_pair(f_image, g_image));
}

std::vector<SampledContour> corresponding_contours(std::vector<SampledContour> contours,
                                                   const CorrespondenceOptions& options) {
    for (std::size_t i = 1; i < contours.size(); ++i) {
        const auto pair = correspond(contours[i - 1], contours[i], options);
        contours[i] = with_origin(contours[i], pair.second - pair.first);
    }
    return contours;
}

}  // namespace stratareeb
