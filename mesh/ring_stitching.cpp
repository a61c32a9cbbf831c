// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ring_stitching.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/compensated_sum.h"

namespace stratareeb {

namespace {

using Border = std::array<std::uint32_t, 2>;

double direction(const Point2& from, const Point2& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
}

//! How far one turns clockwise from one direction to another: above 0, at most a full turn.
double clockwise(double from, double to) {
    double turn = from - to;
    while (turn <= 0) turn += 2 * std::numbers::pi;
    while (turn > 2 * std::numbers::pi) turn -= 2 * std::numbers::pi;
    return turn;
}

struct Box {
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    bool has(const Point2& p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
};

Box box_of(const std::vector<Point2>& ring) {
    Box box;
    for (const Point2& p : ring) {
        box.x0 = std::min(box.x0, p.x);
        box.x1 = std::max(box.x1, p.x);
        box.y0 = std::min(box.y0, p.y);
        box.y1 = std::max(box.y1, p.y);
    }
    return box;
}

bool is_inside_ring(const std::vector<Point2>& ring, const Point2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
            p.x < ring[i].x + (p.y - ring[i].y) / (ring[j].y - ring[i].y) * (ring[j].x - ring[i].x))
            inside = !inside;
    return inside;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> stitch_rings(std::span<const Point2> points,
                                                     std::vector<Border> borders) {
    std::ranges::sort(borders);
    std::vector<char> used(borders.size(), 0);
    const auto leaving = [&](std::uint32_t point) {
        return std::ranges::equal_range(borders, point, {}, [](const Border& b) { return b[0]; });
    };
    //! The unused border that goes on from one, its neighbour on the same side of the area.
    const auto next_of = [&](const Border& came) {
        const double back = direction(points[came[1]], points[came[0]]);
        std::size_t best = borders.size();
        double least = HUGE_VAL;
        for (const Border& candidate : leaving(came[1])) {
            const auto index = static_cast<std::size_t>(&candidate - borders.data());
            if (used[index]) continue;
            const double turn = clockwise(back, direction(points[candidate[0]], points[candidate[1]]));
            if (turn < least) {
                least = turn;
                best = index;
            }
        }
        return best;
    };
    std::vector<std::vector<std::uint32_t>> rings;
    for (std::size_t first = 0; first < borders.size(); ++first) {
        if (used[first]) continue;
        auto& ring = rings.emplace_back();
        for (std::size_t at = first; at < borders.size(); at = next_of(borders[at])) {
            used[at] = 1;
            ring.push_back(borders[at][0]);
            if (borders[at][1] == borders[first][0] && next_of(borders[at]) == borders.size()) break;
        }
    }
    return rings;
}

double ring_area(std::span<const Point2> ring) {
    CompensatedSum sum;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum.add((ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) -
                (ring[i + 1].x - ring[0].x) * (ring[i].y - ring[0].y));
    return sum.value() / 2;
}

std::vector<std::vector<std::vector<Point2>>> nest_rings(std::vector<std::vector<Point2>> rings) {
    std::vector<std::vector<std::vector<Point2>>> nested;
    std::vector<Box> boxes;
    std::vector<double> areas;
    std::vector<std::vector<Point2>> holes;
    for (auto& ring : rings) {
        const double area = ring_area(ring);
        if (area < 0) {
            holes.push_back(std::move(ring));
        } else if (area > 0) {
            boxes.push_back(box_of(ring));
            areas.push_back(area);
            nested.push_back({std::move(ring)});
        }
    }
    for (auto& hole : holes) {
        // Rings may touch in corners, never along edges: the middle of an edge is inside or outside.
        const Point2 middle{(hole[0].x + hole[1].x) / 2, (hole[0].y + hole[1].y) / 2};
        std::size_t around = nested.size();
        for (std::size_t i = 0; i < nested.size(); ++i)
            if (boxes[i].has(middle) && (around == nested.size() || areas[i] < areas[around]) &&
                is_inside_ring(nested[i][0], middle))
                around = i;
        if (around < nested.size()) nested[around].push_back(std::move(hole));
    }
    return nested;
}

}  // namespace stratareeb
