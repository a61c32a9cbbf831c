// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/next_boreholes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "boreholes/hole_triangulation.h"
#include "boreholes/nearest_sites.h"

namespace stratareeb {

namespace {

double distance(const Point2& p, const Point2& q) {
    return std::hypot(q.x - p.x, q.y - p.y);
}

struct Candidate {
    Point2 at;
    double clearance = 0;  // distance to the triangle's corners; of a centroid, other holes may be nearer
    bool is_exact = true;
};

Point2 circumcentre(const Point2& p, const Point2& q, const Point2& r) {
    const double ax = q.x - p.x, ay = q.y - p.y, bx = r.x - p.x, by = r.y - p.y;
    const double a = ax * ax + ay * ay, b = bx * bx + by * by, twice = 2 * (ax * by - ay * bx);
    return {p.x + (by * a - ay * b) / twice, p.y + (ax * b - bx * a) / twice};
}

bool is_acute(const Point2& p, const Point2& q, const Point2& r) {
    const auto dot = [](const Point2& at, const Point2& a, const Point2& b) {
        return (a.x - at.x) * (b.x - at.x) + (a.y - at.y) * (b.y - at.y);
    };
    return dot(p, q, r) > 0 && dot(q, r, p) > 0 && dot(r, p, q) > 0;
}

//! The middle of the gap that a triangle of holes leaves: its circumcentre, which is as far from all holes as any place around,
//! where that lies in it; otherwise its centroid.
Candidate middle_of(const Point2& p, const Point2& q, const Point2& r) {
    if (is_acute(p, q, r)) {
        const Point2 centre = circumcentre(p, q, r);
        return {centre, distance(centre, p)};
    }
    const Point2 centre{(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
    return {centre, std::min({distance(centre, p), distance(centre, q), distance(centre, r)}), false};
}

}  // namespace

std::vector<NextBorehole> next_boreholes(std::span<const Point2> holes, std::size_t count,
                                         const std::function<double(const Point2&)>& expected_error) {
    if (holes.empty()) return {};
    const Point2 origin = holes.front();
    std::vector<Point2> local;
    for (const Point2& p : holes) local.push_back({p.x - origin.x, p.y - origin.y});
    std::map<std::array<std::uint32_t, 3>, double>
        known_error;  // of a gap; most stay from one choice to the next
    std::vector<NextBorehole> chosen;
    while (chosen.size() < count) {
        const HoleTriangulation triangulation(local);
        const NearestSites nearest(local);
        NextBorehole best;
        for (auto corners : triangulation.triangles()) {
            const Candidate middle = middle_of(local[corners[0]], local[corners[1]], local[corners[2]]);
            NextBorehole gap{{origin.x + middle.at.x, origin.y + middle.at.y}};
            gap.area = std::numbers::pi * middle.clearance * middle.clearance;
            std::ranges::sort(corners);
            const auto [place, is_new] = known_error.try_emplace(corners, 0.0);
            if (is_new) place->second = expected_error(gap.at);
            gap.expected_error = place->second;
            if (gap.benefit() <= best.benefit()) continue;
            if (!middle.is_exact)
                gap.area = std::numbers::pi * nearest.nearest(middle.at, 1)[0].squared_distance;
            if (gap.benefit() > best.benefit()) best = gap;
        }
        if (best.benefit() <= 0) break;
        local.push_back({best.at.x - origin.x, best.at.y - origin.y});
        chosen.push_back(best);
    }
    return chosen;
}

}  // namespace stratareeb
