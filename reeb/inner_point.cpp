// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/inner_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace stratareeb {

namespace {

constexpr double kPrecision = 0.1;  // of the distance to the rings
constexpr double kMostSteps = 2e7;  // squares times edges
constexpr std::size_t kMostSquares = 4096;
constexpr std::size_t kProbeLines = 7;  // to start from a place that is surely inside

using Rings = std::span<const std::vector<Point2>>;

double distance_to_edge(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double u =
        squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(a.x + u * dx - p.x, a.y + u * dy - p.y);
}

//! From the rings; negative outside the region.
double depth_inside(Rings rings, const Point2& p) {
    bool inside = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& ring : rings) {
        Point2 a = ring.back();
        for (const Point2& b : ring) {
            if ((a.y < p.y) != (b.y < p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x)
                inside = !inside;
            nearest = std::min(nearest, distance_to_edge(p, a, b));
            a = b;
        }
    }
    return inside ? nearest : -nearest;
}

//! Where a level line through no corner is inside longest, the middle.
Point2 middle_on_line(Rings rings, double y) {
    std::vector<double> passages;
    for (const auto& ring : rings) {
        Point2 a = ring.back();
        for (const Point2& b : ring) {
            if ((a.y < y) != (b.y < y)) passages.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            a = b;
        }
    }
    std::ranges::sort(passages);
    Point2 best{passages.empty() ? rings.front().front().x : passages.front(), y};
    double widest = -1;
    for (std::size_t i = 0; i + 1 < passages.size(); i += 2)
        if (passages[i + 1] - passages[i] > widest) {
            widest = passages[i + 1] - passages[i];
            best.x = passages[i] + widest / 2;
        }
    return best;
}

struct Square {
    Point2 center;
    double half = 0, depth = 0;

    double most() const { return depth + half * std::sqrt(2.0); }  // any place in it can be so deep
    bool operator<(const Square& other) const { return most() < other.most(); }
};

}  // namespace

Point2 inner_point(Rings rings) {
    std::vector<double> heights;
    double left = rings.front().front().x, right = left;
    for (const auto& ring : rings)
        for (const Point2& p : ring) {
            heights.push_back(p.y);
            left = std::min(left, p.x);
            right = std::max(right, p.x);
        }
    const auto edges = static_cast<double>(heights.size());
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    Square best{.center = {}, .half = 0, .depth = -std::numeric_limits<double>::infinity()};
    const auto take_if_deeper = [&](const Square& square) {
        if (square.depth > best.depth) best = square;
    };
    for (std::size_t k = 0; k < kProbeLines; ++k) {
        const std::size_t i = (2 * k + 1) * (heights.size() - 1) / (2 * kProbeLines);
        const Point2 place = middle_on_line(rings, heights[i] + (heights[i + 1] - heights[i]) / 2);
        take_if_deeper({place, 0, depth_inside(rings, place)});
    }
    const double half = std::min(right - left, heights.back() - heights.front()) / 2;
    std::priority_queue<Square> open;
    double steps = 0;
    std::size_t squares = 0;
    const auto add = [&](const Point2& center, double size) {
        const Square square{center, size, depth_inside(rings, center)};
        steps += edges;
        ++squares;
        take_if_deeper(square);
        open.push(square);
    };
    // Of a long narrow box the squares could be too many: then larger ones.
    const double size = std::max({half, (right - left) / 128, (heights.back() - heights.front()) / 128});
    for (double x = left; x < right; x += 2 * size)
        for (double y = heights.front(); y < heights.back(); y += 2 * size) add({x + size, y + size}, size);
    while (!open.empty() && squares < kMostSquares && steps < kMostSteps) {
        const Square square = open.top();
        open.pop();
        if (square.most() <= best.depth * (1 + kPrecision)) break;
        const double quarter = square.half / 2;
        for (const double dx : {-quarter, quarter})
            for (const double dy : {-quarter, quarter})
                add({square.center.x + dx, square.center.y + dy}, quarter);
    }
    return best.center;
}

}  // namespace stratareeb
