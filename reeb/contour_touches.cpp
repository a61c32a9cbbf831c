// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_touches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/soup_topology.h"
#include "reeb/guiding_curve.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kSlimness = 3;  // a tent's half width over its length, so that it stays a tip

double plan_distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

struct Gap {
    double width = std::numeric_limits<double>::max();
    ContourTouch touch;
};

//! The narrowest place: a corner of either contour and the nearest place of the other.
Gap gap_between(std::span<const SampledContour> contours, std::size_t a, std::size_t b) {
    Gap gap;
    for (const bool turned : {false, true}) {
        const SampledContour &from = contours[turned ? b : a], &to = contours[turned ? a : b];
        for (std::size_t i = 0; i < from.points.size(); ++i) {
            const double across = nearest_parameter(to, from.points[i]);
            const Point3 there = point_at(to, across);
            const double width = plan_distance(from.points[i], there);
            if (width >= gap.width) continue;
            const Point3& here = from.points[i];
            gap.width = width;
            gap.touch = {a,
                         b,
                         turned ? across : from.parameters[i],
                         turned ? from.parameters[i] : across,
                         {(here.x + there.x) / 2, (here.y + there.y) / 2, 0}};
        }
    }
    return gap;
}

//! How far along the contour the next place is, the shorter way.
double way_to_next(std::span<const TouchedPlace> places, std::size_t k) {
    double least = 1;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == k) continue;
        const double way = std::abs(places[i].parameter - places[k].parameter);
        least = std::min({least, way, 1 - way});
    }
    return least;
}

}  // namespace

std::vector<ContourTouch> contour_touches(std::span<const SampledContour> contours, double height) {
    std::vector<Gap> gaps;
    for (std::size_t a = 0; a < contours.size(); ++a)
        for (std::size_t b = a + 1; b < contours.size(); ++b) gaps.push_back(gap_between(contours, a, b));
    std::ranges::stable_sort(gaps, {}, &Gap::width);
    DisjointSets joined(contours.size());
    std::vector<ContourTouch> touches;
    for (const Gap& gap : gaps) {
        const auto a = static_cast<std::uint32_t>(gap.touch.first),
                   b = static_cast<std::uint32_t>(gap.touch.second);
        if (joined.find(a) == joined.find(b)) continue;
        joined.unite(a, b);
        touches.push_back(gap.touch);
        touches.back().place.z = height;
    }
    return touches;
}

SampledContour approach_places(const SampledContour& contour, std::span<const TouchedPlace> places,
                               double share, double reach) {
    const double top = places.front().place.z, length = perimeter(contour.points);
    SampledContour lifted = contour;
    for (Point3& p : lifted.points) p.z = share == 1 ? top : p.z + share * (top - p.z);
    std::vector<Guide> guides;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Point3 start = point_at(contour, places[k].parameter);
        const QuadrantGuidingCurve way{start, places[k].place, start};
        Point3 target = share == 1 ? places[k].place : way.at(share / 2);
        target.z = share == 1 ? top : start.z + share * (top - start.z);
        const double tent = std::min({reach, kSlimness * plan_distance(start, places[k].place) / length,
                                      0.5 * way_to_next(places, k)});
        guides.push_back({places[k].parameter, target, tent, tent});
    }
    return guided_contour(lifted, guides);
}

}  // namespace stratareeb
