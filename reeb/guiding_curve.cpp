// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/guiding_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

constexpr double kSamePlace = 1e-9;  // of a contour's way round
constexpr double kNoWeight = 1e-12;  // a hat's foot, but for rounding

//! From a contour's point at share 0 to the critical point at share 1: upright at first, level at last.
Point3 quadrant(const Point3& from, const Point3& critical, double share) {
    if (share <= 0) return from;
    const double left = share < 1 ? std::sqrt((1 - share) * (1 + share)) : 0;
    Point3 p = critical + left * (from - critical);
    p.z = critical.z + (1 - share) * (from.z - critical.z);
    return share < 1 ? p : critical;
}

double shorter_way(double from, double to) {
    const double way = to - from;
    return way - std::floor(way + 0.5);  // in [-1/2, 1/2)
}

void check_guides(std::span<const Guide> guides) {
    for (std::size_t i = 0; i < guides.size(); ++i) {
        const auto& g = guides[i];
        if (!(g.before > 0 && g.before <= 0.5 && g.after > 0 && g.after <= 0.5) ||
            !std::isfinite(g.parameter)) {
            throw InvalidInput(
                fmt::format("guiding curve {}: at {} it reaches {} before and {} after (expected shares "
                            "above 0, at most 0.5)",
                            i, g.parameter, g.before, g.after));
        }
        for (std::size_t j = 0; j < guides.size(); ++j) {
            if (i == j || hat_weight(guides[j].parameter, g.parameter, g.before, g.after) <= kNoWeight)
                continue;
            throw InvalidInput(
                fmt::format("guiding curve {} at {} reaches over curve {} at {}: neither would be met "
                            "(give them shorter reaches)",
                            i, g.parameter, j, guides[j].parameter));
        }
    }
}

double modulo_one(double s) {
    return std::min(s - std::floor(s), std::nextafter(1.0, 0.0));
}

//! Make sure that there is a vertex at s; one that is there already but for rounding will do. The vertex's parameter.
double insert_place(std::vector<double>& parameters, double s) {
    const double place = modulo_one(s);
    const auto next = std::lower_bound(parameters.begin(), parameters.end(), place);
    const double after = next == parameters.end() ? parameters.front() : *next;
    const double before = next == parameters.begin() ? parameters.back() : *(next - 1);
    if (std::abs(shorter_way(place, after)) <= kSamePlace) return after;
    if (std::abs(shorter_way(place, before)) <= kSamePlace) return before;
    parameters.insert(next, place);
    return place;
}

SampledContour with_parameters(const SampledContour& contour, std::vector<double> parameters) {
    auto points = points_at(contour, parameters);
    return {std::move(points), std::move(parameters)};
}

struct NearPlace {
    double parameter = 0;
    double distance = std::numeric_limits<double>::infinity();
};

//! The place of a contour nearest to a point among those that lie on `side` of it (all if side is 0):
//! the part of each segment with (place - point) . side <= 0.
NearPlace nearest_place(const SampledContour& contour, const Point3& point, const Point3& side) {
    NearPlace best;
    const std::size_t size = contour.points.size();
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t next = (i + 1) % size;
        const Point3 a = contour.points[i] - point, way = contour.points[next] - contour.points[i];
        double low = 0, high = 1;
        const double start = a.x * side.x + a.y * side.y, growth = way.x * side.x + way.y * side.y;
        if (start > 0 && start + growth > 0) continue;
        if (start > 0) low = -start / growth;
        if (start + growth > 0) high = -start / growth;
        const double square = way.x * way.x + way.y * way.y;
        const double u = square > 0 ? std::clamp(-(a.x * way.x + a.y * way.y) / square, low, high) : low;
        const double distance = std::hypot(a.x + u * way.x, a.y + u * way.y);
        if (distance >= best.distance) continue;
        const double width = contour.parameters[next] - contour.parameters[i] + (next == 0 ? 1 : 0);
        best = {u == 1 ? contour.parameters[next] : modulo_one(contour.parameters[i] + u * width), distance};
    }
    return best;
}

double reach_between(double from, double to, double reach) {
    const double gap = to - from - std::floor(to - from);  // the way on, from one place to the next
    return gap > 0 ? std::min(reach, gap) : reach;
}

double plan_area(const SampledContour& contour) {
    double sum = 0;
    const Point3& base = contour.points[0];
    for (std::size_t i = 1; i + 1 < contour.points.size(); ++i) {
        sum += cross_product(contour.points[i] - base, contour.points[i + 1] - base).z;
    }
    return sum / 2;
}

//! The contours in the order in which their trace around the critical point does not cross itself: counter-clockwise
//! around it if they run so themselves, the first one first.
std::vector<std::size_t> order_around(std::span<const SampledContour> contours, const Point3& critical) {
    double area = 0;
    std::vector<double> angles;
    for (const auto& contour : contours) {
        area += plan_area(contour);
        const Point3 way = mean_point(contour) - critical;
        const double turn =
            std::atan2(way.y, way.x) / (2 * std::numbers::pi) - (angles.empty() ? 0 : angles[0]);
        angles.push_back(angles.empty() ? turn : turn - std::floor(turn));
    }
    angles[0] = 0;
    std::vector<std::size_t> order(contours.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin() + 1, order.end(), [&](std::size_t a, std::size_t b) {
        return area >= 0 ? angles[a] < angles[b] : angles[a] > angles[b];
    });
    return order;
}

//! The points as they come from the first that is the critical point, round to it.
std::vector<Point3> from_critical(std::vector<Point3> points, const Point3& critical) {
    std::rotate(points.begin(), std::find(points.begin(), points.end(), critical), points.end());
    return points;
}

}  // namespace

Point3 QuadrantGuidingCurve::at(double t) const {
    return t <= 0.5 ? quadrant(start, critical, 2 * t) : quadrant(end, critical, 2 - 2 * t);
}

double hat_weight(double s, double at, double before, double after) {
    const double way = shorter_way(at, s);
    return std::max(0.0, 1 - std::abs(way) / (way < 0 ? before : after));
}

SampledContour guided_contour(const SampledContour& contour, std::span<const Guide> guides) {
    check_contour(contour);
    check_guides(guides);
    auto parameters = contour.parameters;
    std::vector<double> places;
    for (const auto& g : guides) places.push_back(insert_place(parameters, g.parameter));
    for (const auto& g : guides) {
        insert_place(parameters, g.parameter - g.before);
        insert_place(parameters, g.parameter + g.after);
    }
    auto result = with_parameters(contour, std::move(parameters));
    for (std::size_t k = 0; k < guides.size(); ++k) {
        const auto& g = guides[k];
        const Point3 move = g.target - point_at(contour, places[k]);
        for (std::size_t i = 0; i < result.points.size(); ++i) {
            const double weight = hat_weight(result.parameters[i], places[k], g.before, g.after);
            if (weight <= kNoWeight) continue;
            result.points[i] = weight == 1 ? g.target : result.points[i] + weight * move;
        }
    }
    return result;
}

double nearest_parameter(const SampledContour& contour, const Point3& point) {
    check_contour(contour);
    return nearest_place(contour, point, {}).parameter;
}

std::array<double, 2> pinch_parameters(const SampledContour& contour, const Point3& critical) {
    const double first = nearest_parameter(contour, critical);
    const Point3 side = point_at(contour, first) - critical;
    const auto second = nearest_place(contour, critical, side);
    const bool apart = std::isfinite(second.distance) && shorter_way(first, second.parameter) != 0;
    if (!apart || (side.x == 0 && side.y == 0)) {
        throw InvalidInput(
            fmt::format("contour: it does not lie on both sides of the critical point {}, {} (expected "
                        "one that closes there)",
                        critical.x, critical.y));
    }
    return {first, second.parameter};
}

SampledContour approach(const SampledContour& contour, std::span<const double> parameters,
                        const Point3& critical, double share, double reach) {
    check_contour(contour);
    auto vertices = contour.parameters;
    std::vector<double> places;
    for (const double s : parameters) places.push_back(insert_place(vertices, s));
    std::sort(places.begin(), places.end());
    SampledContour base = with_parameters(contour, std::move(vertices));
    std::vector<Guide> guides;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double before = places[(i + places.size() - 1) % places.size()],
                     after = places[(i + 1) % places.size()];
        guides.push_back({places[i], quadrant(point_at(contour, places[i]), critical, share),
                          reach_between(before, places[i], reach), reach_between(places[i], after, reach)});
    }
    for (Point3& p : base.points) p.z = share < 1 ? p.z + share * (critical.z - p.z) : critical.z;
    return guided_contour(base, guides);
}

SampledContour merged_contour(std::span<const SampledContour> contours, std::span<const double> parameters,
                              const Point3& critical, double reach) {
    if (contours.size() < 2 || contours.size() != parameters.size()) {
        throw InvalidInput(fmt::format("merge: {} contours and {} places (expected one each, at least two)",
                                       contours.size(), parameters.size()));
    }
    std::vector<Point3> trace;
    for (const std::size_t i : order_around(contours, critical)) {
        const auto near = approach(contours[i], parameters.subspan(i, 1), critical, 1, reach);
        const auto part = from_critical(near.points, critical);
        trace.insert(trace.end(), part.begin(), part.end());
    }
    return contour_by_perimeter(std::move(trace));
}

std::vector<SampledContour> divided_contours(const SampledContour& contour,
                                             std::span<const double> parameters, const Point3& critical,
                                             double reach) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (std::abs(shorter_way(parameters[i], parameters[j])) > 2 * kSamePlace) continue;
            throw InvalidInput(fmt::format("divide: places {} and {} are both at {}", j, i, parameters[i]));
        }
    }
    if (parameters.size() < 2) {
        throw InvalidInput(fmt::format("divide: {} places (expected at least two)", parameters.size()));
    }
    const auto points = from_critical(approach(contour, parameters, critical, 1, reach).points, critical);
    std::vector<std::vector<Point3>> parts;
    for (const Point3& p : points) {
        if (p == critical) parts.emplace_back();
        parts.back().push_back(p);
    }
    std::vector<SampledContour> result;
    for (auto& part : parts) result.push_back(contour_by_perimeter(std::move(part)));
    return result;
}

}  // namespace stratareeb
