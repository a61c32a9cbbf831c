// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_warping.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kDiagonal = 1.6;  // of a step along both contours, where two along one each weigh 2
constexpr double kSameWay =
    0.01;  // of the perimeter: a distance that weighs as much as a radian between directions

constexpr double kMuchLess =
    0.25;  // where contours move as they are; one that grows at an end moves its centre too

struct Place {
    double x = 0, y = 0;    // in plan
    double dx = 0, dy = 0;  // direction, times a length that makes it comparable
};

std::vector<Place> places_of(const SampledContour& contour, const Point3& origin, std::size_t count,
                             double weight) {
    const auto points = points_at(contour, even_parameters(count));
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i) {
        const Point3 way = points[(i + 1) % count] - points[(i + count - 1) % count];
        const double length = std::hypot(way.x, way.y), scale = length > 0 ? weight / length : 0;
        places.push_back({points[i].x - origin.x, points[i].y - origin.y, scale * way.x, scale * way.y});
    }
    return places;
}

double unlikeness(const Place& a, const Place& b) {
    const double x = a.x - b.x, y = a.y - b.y, dx = a.dx - b.dx, dy = a.dy - b.dy;
    return x * x + y * y + dx * dx + dy * dy;
}

//! A way around both contours: pairs of places, from (first, second) to (first + count, second + count).
struct Way {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    double cost = 0;
};

//! The cheapest way that starts with these places.
Way way_from(const std::vector<Place>& first, const std::vector<Place>& second, std::size_t i0,
             std::size_t j0) {
    const std::size_t size = first.size(), n = size + 1;
    std::vector<std::uint8_t> came(n * n, 0);  // 1: along the first, 2: the second, 3: both
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<double> row(n), last(n, kNever);
    for (std::size_t i = 0; i < n; ++i) {
        const Place& a = first[(i0 + i) % size];
        for (std::size_t j = 0; j < n; ++j) {
            const double own = unlikeness(a, second[(j0 + j) % size]);
            double least = i == 0 && j == 0 ? 0 : kNever;
            std::uint8_t by = 0;
            if (i > 0 && j > 0) least = last[j - 1] + kDiagonal * own, by = 3;
            if (i > 0 && last[j] + own < least) least = last[j] + own, by = 1;
            if (j > 0 && row[j - 1] + own < least) least = row[j - 1] + own, by = 2;
            row[j] = least;
            came[i * n + j] = by;
        }
        std::swap(row, last);
    }
    Way way{.pairs = {}, .cost = last[size]};
    for (std::size_t i = size, j = size;;) {
        way.pairs.emplace_back(i0 + i, j0 + j);
        const std::uint8_t by = came[i * n + j];
        if (by == 0) break;
        i -= by & 1u;
        j -= by >> 1u;
    }
    std::ranges::reverse(way.pairs);
    return way;
}

//! Where the way is half round is a better place to start than one that was only guessed.
Way closed_way(const std::vector<Place>& first, const std::vector<Place>& second) {
    const Way guess = way_from(first, second, 0, 0);
    const auto [i, j] = guess.pairs[guess.pairs.size() / 2];
    const std::size_t n = first.size();
    Way way = way_from(first, second, i % n, j % n);
    return way.cost < guess.cost ? way : guess;
}

//! For each place of the second contour the middle of those of the first that it is paired with, from the way's start.
std::vector<double> middles(const Way& way, std::size_t count) {
    const std::size_t start = way.pairs.front().second;
    std::vector<double> low(count + 1, std::numeric_limits<double>::max()), high(count + 1, 0);
    for (const auto& [i, j] : way.pairs) {
        low[j - start] = std::min<double>(low[j - start], i);
        high[j - start] = std::max<double>(high[j - start], i);
    }
    low[0] = std::min(low[0], low[count] - static_cast<double>(count));  // the same place, a turn later
    std::vector<double> result;
    for (std::size_t k = 0; k < count; ++k) result.push_back((low[k] + high[k]) / 2);
    return result;
}

}  // namespace

double ContourWarp::partner(double s) const {
    const auto count = static_cast<double>(partners.size());
    const double turn = std::floor(s - start), k = (s - start - turn) * count;
    const std::size_t low = std::min(static_cast<std::size_t>(k), partners.size() - 1);
    const double from = partners[low], to = low + 1 < partners.size() ? partners[low + 1] : partners[0] + 1;
    return turn + from + (k - static_cast<double>(low)) * (to - from);
}

ContourWarp contour_warp(const SampledContour& first, const SampledContour& second, std::size_t count) {
    const double weight = kSameWay * (perimeter(first.points) + perimeter(second.points)) / 2;
    const Point3 middle = mean_point(first);
    const auto a = places_of(first, middle, count, weight);
    const Way still = closed_way(a, places_of(second, middle, count, weight)),
              moved = closed_way(a, places_of(second, mean_point(second), count, weight));
    const Way& way = moved.cost < kMuchLess * still.cost ? moved : still;
    const auto places = static_cast<double>(count);
    ContourWarp warp{.is_centred = &way == &moved,
                     .start = static_cast<double>(way.pairs.front().second) / places,
                     .partners = middles(way, count)};
    for (double& s : warp.partners) s /= places;
    return warp;
}

}  // namespace stratareeb
