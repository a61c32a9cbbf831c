// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_bouquet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace stratareeb {

namespace {

//! A way from the critical point round to it, the solid on its left.
struct Loop {
    PointLoop points;                   // without the critical point
    std::size_t next = 0;               // on the side that is given
    double departure = 0, arrival = 0;  // directions seen from the critical point, radians
};

std::vector<Loop> loops_of(std::span<const PointLoop> contours, const std::vector<bool>& is_hole,
                           std::uint32_t critical) {
    std::vector<Loop> loops;
    for (std::size_t c = 0; c < contours.size(); ++c) {
        PointLoop contour = contours[c];
        if (is_hole[c]) std::ranges::reverse(contour);
        std::ranges::rotate(contour, std::ranges::find(contour, critical));
        const std::size_t first = loops.size();
        for (const std::uint32_t point : contour)
            if (point == critical)
                loops.push_back({.points = {}, .next = loops.size() + 1});
            else
                loops.back().points.push_back(point);
        loops.back().next = first;
    }
    return loops;
}

double direction(const Point3& from, const Point3& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
}

//! For each loop the one that starts next, turning about the critical point from where it ends.
std::vector<std::size_t> next_by_turning(const std::vector<Loop>& loops, bool counter_clockwise) {
    std::vector<std::size_t> next(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        double least = 4 * std::numbers::pi;
        for (std::size_t k = 0; k < loops.size(); ++k) {
            double turn = loops[k].departure - loops[i].arrival;
            if (!counter_clockwise) turn = -turn;
            if (turn < 0) turn += 2 * std::numbers::pi;
            if (turn >= least) continue;
            least = turn;
            next[i] = k;
        }
    }
    return next;
}

bool is_permutation_of_all(std::vector<std::size_t> next) {
    std::ranges::sort(next);
    for (std::size_t i = 0; i < next.size(); ++i)
        if (next[i] != i) return false;
    return true;
}

std::vector<PointLoop> joined(const std::vector<Loop>& loops, const std::vector<std::size_t>& next,
                              std::uint32_t critical) {
    std::vector<PointLoop> curves;
    std::vector<bool> used(loops.size(), false);
    for (std::size_t first = 0; first < loops.size(); ++first) {
        if (used[first]) continue;
        PointLoop& curve = curves.emplace_back();
        for (std::size_t l = first; !used[l]; l = next[l]) {
            used[l] = true;
            curve.push_back(critical);
            curve.insert(curve.end(), loops[l].points.begin(), loops[l].points.end());
        }
    }
    return curves;
}

}  // namespace

double twice_plan_area(std::span<const std::uint32_t> loop, std::span<const Point3> points) {
    double sum = 0;
    const Point3& o = points[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point3 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
        sum += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return sum;
}

std::optional<std::vector<PointLoop>> contours_across(std::span<const PointLoop> contours,
                                                      const std::vector<bool>& is_hole,
                                                      std::uint32_t critical,
                                                      std::span<const Point3> points) {
    std::vector<Loop> loops = loops_of(contours, is_hole, critical);
    for (Loop& loop : loops) {
        if (loop.points.empty()) return std::nullopt;
        loop.departure = direction(points[critical], points[loop.points.front()]);
        loop.arrival = direction(points[critical], points[loop.points.back()]);
    }
    std::vector<std::size_t> given;
    for (const Loop& loop : loops) given.push_back(loop.next);
    // One of the two ways to turn gives back what is given, the other the far side.
    for (const bool counter_clockwise : {true, false}) {
        if (next_by_turning(loops, !counter_clockwise) != given) continue;
        const std::vector<std::size_t> across = next_by_turning(loops, counter_clockwise);
        if (!is_permutation_of_all(across)) continue;
        std::vector<PointLoop> curves = joined(loops, across, critical);
        for (PointLoop& curve : curves)
            if (twice_plan_area(curve, points) < 0) std::ranges::reverse(curve);
        return curves;
    }
    return std::nullopt;
}

}  // namespace stratareeb
