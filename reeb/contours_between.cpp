// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contours_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/ring_crossings.h"
#include "reeb/contour_matching.h"
#include "reeb/homotopy.h"

namespace stratareeb {

std::vector<Point3> contour_between(const std::vector<LevelContour>& contours, std::size_t k, double z,
                                    const HeightScale& scale, HomotopyKind kind) {
    const std::size_t first = k > 0 ? k - 1 : 0, last = std::min(k + 2, contours.size() - 1);
    std::vector<SampledContour> shapes;
    std::vector<double> heights;
    for (std::size_t i = first; i <= last; ++i) {
        shapes.push_back(contour_by_perimeter(contours[i].points));
        heights.push_back(contours[i].z);
    }
    const double below = scale.place(contours[k].z), above = scale.place(contours[k + 1].z);
    return ContourHomotopy(matched_contours(std::move(shapes)), heights,
                           {.kind = kind, .pace = HomotopyPace::Round}, scale)
        .contour(k - first, (scale.place(z) - below) / (above - below))
        .points;
}

bool crosses_between(const std::vector<LevelContour>& contours, std::size_t k, const HeightScale& scale,
                     HomotopyKind kind) {
    return std::ranges::any_of(std::array{0.25, 0.5, 0.75}, [&](double t) {
        std::vector<std::vector<Point2>> ring(1);
        const double z = contours[k].z + t * (contours[k + 1].z - contours[k].z);
        for (const Point3& p : contour_between(contours, k, z, scale, kind)) ring[0].push_back({p.x, p.y});
        return !ring_crossings(ring, {.most = 1}).empty();
    });
}

double plan_deviation(const std::vector<Point3>& from, const std::vector<Point3>& to) {
    constexpr std::size_t kPlaces = 64;
    const std::size_t step = 1 + from.size() / kPlaces;
    double furthest = 0;
    for (std::size_t i = 0; i < from.size(); i += step) {
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < to.size(); ++k) {
            const Point3 &a = to[k], &b = to[(k + 1) % to.size()];
            const double x = b.x - a.x, y = b.y - a.y, px = from[i].x - a.x, py = from[i].y - a.y;
            const double square = x * x + y * y;
            const double u = square > 0 ? std::clamp((px * x + py * y) / square, 0.0, 1.0) : 0;
            least = std::min(least, std::hypot(px - u * x, py - u * y));
        }
        furthest = std::max(furthest, least);
    }
    return furthest;
}

}  // namespace stratareeb
