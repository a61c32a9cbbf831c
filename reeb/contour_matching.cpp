// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_matching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reeb/contour_alignment.h"
#include "reeb/contour_warping.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLeastPlaces = 64, kMostPlaces = 128;  // on each contour; time grows with the square
constexpr double kWindow = 1.5;    // places around a partner in which a nearer one is looked for
constexpr double kRelaxation = 2;  // towards parameters by length, for a mean way of one perimeter
constexpr double kLeastShare = 1e-4, kMostShare = 0.1;  // of parameters by length
constexpr double kSame = 1e-9;                          // parameters
constexpr double kMuchLess = 0.25;  // of the mean square by which ways from contour to contour differ
constexpr double kAlike = 2e-3;     // of the perimeter: ways that differ by no more leave nothing to gain
const double kBelowOne = std::nextafter(1.0, 0.0);

double plan_square(const Point3& a, const Point3& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

//! A contour by length, counted on around it without end.
class Line {
 public:
    explicit Line(const SampledContour& contour) : contour_(contour) {}

    Point3 at(double s) const { return point_at(contour_, s); }

    //! The place nearest to a point in plan, not more than a window from where it is thought to be.
    double nearest(const Point3& p, double guess, double window) const {
        const auto& own = contour_.parameters;
        const std::size_t n = own.size();
        const double low = guess - window, turns = std::floor(low);
        auto i = static_cast<std::size_t>(std::ranges::upper_bound(own, low - turns) - own.begin());
        double best = guess, least = plan_square(at(guess), p), from = low;
        Point3 start = at(low);
        for (double turn = turns; from < guess + window;) {
            if (i == n) i = 0, ++turn;
            const bool is_last = own[i] + turn >= guess + window;
            const double to = is_last ? guess + window : own[i] + turn;
            const Point3 end = is_last ? at(to) : contour_.points[i];
            const double x = end.x - start.x, y = end.y - start.y, square = x * x + y * y;
            const double u =
                square > 0 ? std::clamp(((p.x - start.x) * x + (p.y - start.y) * y) / square, 0.0, 1.0) : 0;
            const double own_square = plan_square(between(start, end, u), p);
            if (own_square < least) {
                least = own_square;
                best = from + u * (to - from);
            }
            from = to;
            start = end;
            ++i;
        }
        return best;
    }

 private:
    const SampledContour& contour_;
};

//! What the first contour's own parameter is at a place by length, counted on around it.
double own_parameter(const SampledContour& by_length, const std::vector<double>& own, double s) {
    const double turn = std::floor(s), place = s - turn;
    const auto& lengths = by_length.parameters;
    const std::size_t n = lengths.size();
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(lengths, place) - lengths.begin());
    const std::size_t from = next - 1;  // the first is at 0
    const double start = own[from] + (own[from] < own[0] ? 1 : 0);
    const double low = lengths[from], high = next < n ? lengths[next] : 1;
    double end = next < n ? own[next] + (own[next] < own[0] ? 1 : 0) : own[0] + 1;
    if (end < start) end = start;
    return turn + start + (high > low ? (place - low) / (high - low) * (end - start) : 0);
}

//! Parameters modulo one, from the least.
SampledContour from_zero(SampledContour contour) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < contour.parameters.size(); ++i) {
        double& s = contour.parameters[i];
        s = std::min(s - std::floor(s), kBelowOne);
        if (i > 0 && s < contour.parameters[i - 1]) first = i;
    }
    std::ranges::rotate(contour.parameters, contour.parameters.begin() + static_cast<std::ptrdiff_t>(first));
    std::ranges::rotate(contour.points, contour.points.begin() + static_cast<std::ptrdiff_t>(first));
    return contour;
}

//! The places by length on the first contour that the second one's points belong to, not falling, once around at most.
std::vector<double> partners_of_points(const SampledContour& a, const SampledContour& b) {
    const std::size_t count =
        std::clamp(2 * std::max(a.points.size(), b.points.size()), kLeastPlaces, kMostPlaces);
    const ContourWarp warp = contour_warp(a, b, count);
    const Line line(a);
    const Point3 move = warp.is_centred ? mean_point(a) - mean_point(b) : Point3{};
    const double window = kWindow / static_cast<double>(count);
    std::vector<double> partners;
    double way = 0;  // in the mean, as a share of the perimeter
    for (std::size_t i = 0; i < b.points.size(); ++i) {
        const Point3 p = b.points[i] + move;
        double s = line.nearest(p, warp.partner(b.parameters[i]), window);
        way += std::sqrt(plan_square(line.at(s), p));
        if (i > 0) s = std::clamp(s, partners.back(), std::max(partners.back(), partners.front() + 1));
        partners.push_back(s);
    }
    way /= static_cast<double>(b.points.size()) * perimeter(a.points);
    double offset = 0;
    for (std::size_t i = 0; i < partners.size(); ++i) offset += partners[i] - b.parameters[i];
    offset /= static_cast<double>(partners.size());
    const double share = std::clamp(kRelaxation * way, kLeastShare, kMostShare);
    for (std::size_t i = 0; i < partners.size(); ++i)
        partners[i] += share * (b.parameters[i] + offset - partners[i]);
    return partners;
}

//! The mean square by which the ways from points of one contour to those of equal parameters on the other differ from their mean.
double spread_between(const SampledContour& a, const SampledContour& b) {
    double x = 0, y = 0, square = 0, weight = 0;
    for (const bool from_a : {true, false}) {
        const SampledContour &from = from_a ? a : b, &to = from_a ? b : a;
        const auto there = points_at(to, from.parameters);
        const std::size_t n = there.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Point3 &p = from.points[i], &before = from.points[(i + n - 1) % n],
                         &after = from.points[(i + 1) % n];
            const double own = std::sqrt(plan_square(p, before)) + std::sqrt(plan_square(p, after));
            const double dx = from_a ? there[i].x - p.x : p.x - there[i].x,
                         dy = from_a ? there[i].y - p.y : p.y - there[i].y;
            x += own * dx;
            y += own * dy;
            square += own * (dx * dx + dy * dy);
            weight += own;
        }
    }
    return weight > 0 ? square / weight - (x * x + y * y) / (weight * weight) : 0;
}

//! Parameters by length, counted from anywhere?
bool is_turned_only(const std::vector<double>& own, const std::vector<double>& lengths) {
    for (std::size_t i = 0; i < own.size(); ++i) {
        const double off = own[i] - own[0] - lengths[i];
        if (std::abs(off - std::round(off)) > kSame) return false;
    }
    return true;
}

//! The second contour with the first one's own parameters at partners, which are places by length.
SampledContour with_parameters_of(const SampledContour& first, const SampledContour& by_length,
                                  SampledContour second, const std::vector<double>& partners) {
    const double last = own_parameter(by_length, first.parameters, partners.front()) + kBelowOne;
    for (std::size_t i = 0; i < partners.size(); ++i)
        second.parameters[i] = std::min(own_parameter(by_length, first.parameters, partners[i]), last);
    return from_zero(std::move(second));
}

SampledContour by_length(const SampledContour& contour) {
    return contour_by_perimeter(contour.points);
}

}  // namespace

SampledContour matched_contour(const SampledContour& first, const SampledContour& second, Matching matching) {
    SampledContour aligned = with_origin(second, aligned_origin(first, second));
    if (first.points.size() < 3 || second.points.size() < 3) return aligned;
    const SampledContour a = by_length(first);
    const bool is_plain = is_turned_only(first.parameters, a.parameters);
    if (is_plain && matching == Matching::ByLength) return aligned;
    SampledContour b = by_length(second);
    b = with_origin(b, aligned_origin(a, b));
    SampledContour plain = is_plain ? aligned : with_parameters_of(first, a, b, b.parameters);
    if (matching == Matching::ByLength) return plain;
    const double spread = matching == Matching::ByShape ? HUGE_VAL : spread_between(first, plain);
    const double alike = kAlike * perimeter(a.points);
    if (spread < alike * alike) return plain;
    SampledContour shaped = with_parameters_of(first, a, b, partners_of_points(a, b));
    const bool is_better =
        matching == Matching::ByShape || spread_between(first, shaped) < kMuchLess * spread;
    return is_better ? shaped : plain;
}

std::vector<SampledContour> matched_contours(std::vector<SampledContour> contours) {
    for (std::size_t i = 1; i < contours.size(); ++i)
        contours[i] = matched_contour(contours[i - 1], contours[i]);
    return contours;
}

}  // namespace stratareeb
