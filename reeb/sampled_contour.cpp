// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/sampled_contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

const double kBelowOne = std::nextafter(1.0, 0.0);

double modulo_one(double s) {
    return std::min(s - std::floor(s), kBelowOne);
}

}  // namespace

double perimeter(std::span<const Point3> points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += magnitude(points[(i + 1) % points.size()] - points[i]);
    }
    return sum;
}

SampledContour contour_by_perimeter(std::vector<Point3> points) {
    if (points.empty()) throw InvalidInput("contour: no points (expected at least one)");
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i])) throw InvalidInput(fmt::format("contour: point {} is not finite", i));
    }
    const double whole = perimeter(points);
    if (whole == 0) return {points, even_parameters(points.size())};
    std::vector<double> parameters;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) sum += magnitude(points[i] - points[i - 1]);
        parameters.push_back(std::min(sum / whole, kBelowOne));
    }
    return {std::move(points), std::move(parameters)};
}

void check_contour(const SampledContour& contour) {
    const auto& s = contour.parameters;
    if (contour.points.empty() || contour.points.size() != s.size()) {
        throw InvalidInput(
            fmt::format("contour: {} points and {} parameters (expected as many, at least one)",
                        contour.points.size(), s.size()));
    }
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (!is_finite(contour.points[i]))
            throw InvalidInput(fmt::format("contour: point {} is not finite", i));
        if (!(s[i] >= 0 && s[i] < 1) || (i > 0 && s[i] < s[i - 1])) {
            throw InvalidInput(fmt::format(
                "contour: parameter {} of point {} (expected them in [0, 1), not falling)", s[i], i));
        }
    }
}

std::vector<Point3> points_at(const SampledContour& contour, std::span<const double> s) {
    const auto& own = contour.parameters;
    const std::size_t size = own.size();
    std::vector<Point3> result;
    result.reserve(s.size());
    std::size_t next = 0;  // the first point after the place
    for (const double any : s) {
        const double place = modulo_one(any);
        if (next > 0 && own[next - 1] > place) next = 0;
        while (next < size && own[next] <= place) ++next;
        const std::size_t from = next == 0 ? size - 1 : next - 1, to = next == size ? 0 : next;
        const double start = own[from] - (next == 0 ? 1 : 0), end = own[to] + (next == size ? 1 : 0);
        result.push_back(between(contour.points[from], contour.points[to], (place - start) / (end - start)));
    }
    return result;
}

Point3 point_at(const SampledContour& contour, double s) {
    return points_at(contour, std::span(&s, 1)).front();
}

SampledContour with_origin(const SampledContour& contour, double origin) {
    const double at = modulo_one(origin);
    const auto first = std::lower_bound(contour.parameters.begin(), contour.parameters.end(), at) -
                       contour.parameters.begin();
    SampledContour result = contour;
    std::rotate(result.points.begin(), result.points.begin() + first, result.points.end());
    std::rotate(result.parameters.begin(), result.parameters.begin() + first, result.parameters.end());
    for (double& s : result.parameters) s = s >= at ? s - at : std::min(s - at + 1, kBelowOne);
    return result;
}

SampledContour with_short_sides(const SampledContour& contour, double most) {
    SampledContour result;
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Point3 &a = contour.points[i], &b = contour.points[next];
        const double s = contour.parameters[i], length = magnitude(b - a);
        double rest = contour.parameters[next] - s;
        if (next == 0) rest += 1;
        const auto parts =
            length > most && rest > 0 ? static_cast<std::size_t>(std::ceil(length / most)) : std::size_t{1};
        result.points.push_back(a);
        result.parameters.push_back(s);
        for (std::size_t k = 1; k < parts; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(parts), at = s + share * rest;
            result.points.push_back(a + share * (b - a));
            result.parameters.push_back(at);
        }
    }
    const auto beyond = std::ranges::find_if(result.parameters, [](double s) { return s >= 1; });
    const auto shift = beyond - result.parameters.begin();
    for (auto at = beyond; at != result.parameters.end(); ++at) *at -= 1;
    std::ranges::rotate(result.parameters, result.parameters.begin() + shift);
    std::ranges::rotate(result.points, result.points.begin() + shift);
    return result;
}

Point3 mean_point(const SampledContour& contour) {
    const std::size_t size = contour.points.size();
    const Point3& start = contour.points[0];  // sums of differences: nothing lost far from the origin
    Point3 sum;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t next = (i + 1) % size;
        const double share = contour.parameters[next] - contour.parameters[i] + (next == 0 ? 1 : 0);
        sum += (0.5 * share) * ((contour.points[i] - start) + (contour.points[next] - start));
    }
    return start + sum;
}

double mean_distance(const SampledContour& a, const SampledContour& b, std::span<const double> s) {
    const auto p = points_at(a, s), q = points_at(b, s);
    double sum = 0;
    for (std::size_t i = 0; i < s.size(); ++i) sum += magnitude(q[i] - p[i]);
    return sum / static_cast<double>(s.size());
}

std::vector<double> even_parameters(std::size_t n) {
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i) result[i] = static_cast<double>(i) / static_cast<double>(n);
    return result;
}

}  // namespace stratareeb
