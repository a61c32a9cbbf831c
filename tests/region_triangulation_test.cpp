// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/region_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

std::vector<Point2> ring(Point2 center, double radius, int corners, double wave, int waves) {
    std::vector<Point2> points;
    for (int i = 0; i < corners; ++i) {
        const double u = 2 * std::numbers::pi * i / corners, r = radius * (1 + wave * std::sin(waves * u));
        points.push_back({center.x + r * std::cos(u), center.y + r * std::sin(u)});
    }
    return points;
}

double area_of(const std::vector<Point2>& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point2 &o = p[0], &a = p[i], &b = p[(i + 1) % p.size()];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return std::abs(twice) / 2;
}

struct Case {
    std::vector<RegionRing> rings;
    std::vector<RegionPoint> inside;
};

Case random_case(std::uint64_t seed, Point2 at) {
    std::mt19937_64 random(seed);
    const auto unit = [&] { return static_cast<double>(random() % 1000) / 1000; };
    const auto corners = [&] { return 3 + static_cast<int>(random() % 90); };
    Case result;
    result.rings.push_back({ring(at, 10, 20 + corners(), 0.2 * unit(), 5), 0});
    const int holes = static_cast<int>(random() % 4);
    for (int k = 0; k < holes; ++k) {
        const double u = 2 * std::numbers::pi * k / holes;
        result.rings.push_back({ring({at.x + 4.5 * std::cos(u), at.y + 4.5 * std::sin(u)}, 0.5 + 1.5 * unit(),
                                     corners(), 0.4 * unit(), 3),
                                static_cast<std::uint32_t>(random() % 2)});
    }
    result.inside.push_back({.place = {at.x + 0.1, at.y + 0.2}, .size = 0.3});
    return result;
}

//! All that the header says of the triangles.
void expect_sound(const Case& region, const RegionTriangulation& found) {
    std::vector<Point2> points;
    std::vector<std::uint32_t> side;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> ring_edges;
    double area = 0;
    for (std::size_t r = 0; r < region.rings.size(); ++r) {
        const auto& own = region.rings[r].points;
        for (std::uint32_t i = 0; i < own.size(); ++i) {
            const auto a = static_cast<std::uint32_t>(points.size()) + i,
                       b = static_cast<std::uint32_t>(points.size() + (i + 1) % own.size());
            ring_edges[std::minmax(a, b)] = 0;
        }
        points.insert(points.end(), own.begin(), own.end());
        side.resize(points.size(), region.rings[r].side);
        area += (r == 0 ? 1 : -1) * area_of(own);
    }
    for (const RegionPoint& p : region.inside) points.push_back(p.place);
    points.insert(points.end(), found.added.begin(), found.added.end());
    side.resize(points.size(), ~0u);
    double sum = 0;
    std::vector<bool> used(points.size(), false);
    for (const auto& t : found.triangles) {
        const Point2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
        const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        EXPECT_GT(twice, 0);
        sum += twice / 2;
        for (std::size_t i = 0; i < 3; ++i) {
            used[t[i]] = true;
            const auto edge = ring_edges.find(std::minmax(t[i], t[(i + 1) % 3]));
            if (edge != ring_edges.end())
                ++edge->second;
            else
                EXPECT_TRUE(side[t[i]] == ~0u || side[t[i]] != side[t[(i + 1) % 3]]) << "a chord";
        }
    }
    EXPECT_NEAR(sum, area, 1e-6 * area);
    for (const auto& [edge, count] : ring_edges) EXPECT_EQ(count, 1);
    EXPECT_TRUE(std::ranges::all_of(used, [](bool u) { return u; }));
}

TEST(RegionTriangulation, fills_the_region_between_rings_and_has_no_chords) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const Point2 at = seed % 2 ? Point2{5'000'000, 400'000} : Point2{0, 0};
        const Case region = random_case(seed, at);
        const auto found =
            triangulate_region(region.rings, region.inside, {.largest_edge = 0.5 + 0.01 * double(seed)});
        expect_sound(region, found);
        const auto again =
            triangulate_region(region.rings, region.inside, {.largest_edge = 0.5 + 0.01 * double(seed)});
        EXPECT_EQ(found.triangles, again.triangles);
        EXPECT_EQ(found.added, again.added);
    }
}

TEST(RegionTriangulation, has_edges_of_the_size_asked_for) {
    const std::vector<RegionRing> square{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0}};
    std::size_t before = 1;
    for (const double edge : {4.0, 2.0, 1.0, 0.5}) {
        const auto found = triangulate_region(square, {}, {.largest_edge = edge});
        const double triangles = static_cast<double>(found.triangles.size()),
                     even = 100 / (std::sqrt(3) / 4 * edge * edge);
        EXPECT_GT(triangles, 0.5 * even);
        EXPECT_LT(triangles, 4 * even + 20);
        EXPECT_GT(found.triangles.size(), before);
        before = found.triangles.size();
    }
    EXPECT_LE(triangulate_region(square, {}, {.largest_edge = 0.01, .most_added = 500}).added.size(), 520u);
}

TEST(RegionTriangulation, refuses_what_is_no_region) {
    const RegionRing outer{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0},
        crossing{{{5, 5}, {15, 5}, {15, 6}, {5, 6}}, 1}, touching{{{0, 0}, {5, 2}, {2, 5}}, 1};
    EXPECT_THROW(triangulate_region(std::vector{outer, crossing}, {}), InvalidInput);
    EXPECT_THROW(triangulate_region(std::vector{outer, touching}, {}), InvalidInput);
    for (const Point2& p : {Point2{11, 5}, Point2{5, 0}, Point2{10, 10}})
        EXPECT_THROW(triangulate_region(std::vector{outer}, std::vector<RegionPoint>{{.place = p}}),
                     InvalidInput);
    const RegionPoint twice{.place = {5, 5}};
    EXPECT_THROW(triangulate_region(std::vector{outer}, std::vector{twice, twice}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
