// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hole_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

std::vector<Point2> random_places(std::uint64_t seed, std::size_t count, double low = 0, double high = 100) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(low, high);
    std::vector<Point2> at(count);
    for (Point2& p : at) p = {anywhere(random), anywhere(random)};
    return at;
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

Point2 closest_on(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return {a.x + t * dx, a.y + t * dy};
}

Point2 place_of(const PlanLocation& l, const std::vector<Point2>& sites) {
    Point2 p;
    for (int k = 0; k < 3; ++k) {
        p.x += l.weight[k] * sites[l.site[k]].x;
        p.y += l.weight[k] * sites[l.site[k]].y;
    }
    return p;
}

PlanLocation locate(const HoleTriangulation& holes, const Point2& p) {
    return holes.locate(std::span(&p, 1))[0];
}

std::vector<NaturalPlace> natural_places(const HoleTriangulation& holes, const std::vector<Point2>& where) {
    std::vector<NaturalPlace> result(where.size());
    std::vector<int> visits(where.size());
    holes.for_each_natural_place(where, [&](std::size_t i, const NaturalPlace& place) {
        result[i] = place;
        ++visits[i];
    });
    EXPECT_TRUE(std::ranges::all_of(visits, [](int n) { return n == 1; })) << "each place once";
    return result;
}

//! A square grid turned by an angle, far from the origin: its rows are straight but for rounding.
std::vector<Point2> turned_grid(int side, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<Point2> sites;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            sites.push_back({5e6 + 25 * (i * std::cos(angle) - j * std::sin(angle)),
                             4.9e6 + 25 * (i * std::sin(angle) + j * std::cos(angle))});
    return sites;
}

void expect_sound_hull(const HoleTriangulation& holes) {
    const auto& hull = holes.hull_edges();
    for (std::size_t e = 0; e < hull.size(); ++e) {
        EXPECT_EQ(hull[e][1], hull[(e + 1) % hull.size()][0]) << "a closed chain";
        const Point2 &a = holes.sites()[hull[e][0]], &b = holes.sites()[hull[e][1]];
        const Point2 out = holes.outward(e);
        EXPECT_NEAR(std::hypot(out.x, out.y), 1, 1e-12);
        EXPECT_NEAR(out.x * (b.x - a.x) + out.y * (b.y - a.y), 0, 1e-9 * distance(a, b));
        EXPECT_LT(turn(a, b, {a.x + out.x, a.y + out.y}), 0) << "inside lies to the left";
    }
}

TEST(HoleTriangulation, covers_the_hull_with_delaunay_triangles) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto sites = random_places(seed, 3 + 2 * seed);
        const HoleTriangulation holes(sites);
        double area = 0, hull_area = 0;
        for (const auto& [a, b, c] : holes.triangles()) {
            EXPECT_GT(turn(sites[a], sites[b], sites[c]), 0) << "counter-clockwise";
            area += turn(sites[a], sites[b], sites[c]) / 2;
            for (std::uint32_t d = 0; d < sites.size(); ++d) {  // the empty circle
                if (d == a || d == b || d == c) continue;
                const auto lifted = [&](std::uint32_t i) {
                    const double x = sites[i].x - sites[d].x, y = sites[i].y - sites[d].y;
                    return std::array{x, y, x * x + y * y};
                };
                const auto u = lifted(a), v = lifted(b), w = lifted(c);
                EXPECT_LE(u[2] * (v[0] * w[1] - v[1] * w[0]) - v[2] * (u[0] * w[1] - u[1] * w[0]) +
                              w[2] * (u[0] * v[1] - u[1] * v[0]),
                          1e-3);
            }
        }
        for (const auto& [a, b] : holes.hull_edges())
            hull_area += (sites[a].x * sites[b].y - sites[b].x * sites[a].y) / 2;
        EXPECT_NEAR(area, hull_area, 1e-9 * hull_area);
        expect_sound_hull(holes);
    }
}

TEST(HoleTriangulation, locates_places_as_a_search_through_all_triangles_does) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto sites = random_places(seed, 3 + 3 * seed);
        const HoleTriangulation holes(sites);
        const auto where = random_places(seed + 100, 300, -30, 130);
        const auto found = holes.locate(where);
        for (std::size_t i = 0; i < where.size(); ++i) {
            const Point2& p = where[i];
            ASSERT_NEAR(found[i].weight[0] + found[i].weight[1] + found[i].weight[2], 1, 1e-14);
            ASSERT_GE(std::ranges::min(found[i].weight), 0);
            bool inside = false;
            for (const auto& [a, b, c] : holes.triangles()) {
                const double wa = turn(p, sites[b], sites[c]), wb = turn(sites[a], p, sites[c]),
                             wc = turn(sites[a], sites[b], p);
                if (wa <= 0 || wb <= 0 || wc <= 0) continue;
                inside = true;
                std::map<std::uint32_t, double> weight;
                for (int k = 0; k < 3; ++k) weight[found[i].site[k]] += found[i].weight[k];
                const double sum = wa + wb + wc;
                EXPECT_NEAR(weight[a], wa / sum, 1e-12);
                EXPECT_NEAR(weight[b], wb / sum, 1e-12);
                EXPECT_NEAR(weight[c], wc / sum, 1e-12);
            }
            ASSERT_EQ(found[i].inside, inside);
            if (inside) continue;
            double closest = std::numeric_limits<double>::infinity();
            for (const auto& [a, b] : holes.hull_edges())
                closest = std::min(closest, distance(p, closest_on(p, sites[a], sites[b])));
            EXPECT_NEAR(distance(p, place_of(found[i], sites)), closest, 1e-9);
            EXPECT_EQ(found[i].weight[2], 0);
        }
    }
}

TEST(HoleTriangulation, locates_sites_and_edges_as_inside) {
    const auto sites = random_places(5, 30);
    const HoleTriangulation holes(sites);
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const PlanLocation l = locate(holes, sites[i]);
        EXPECT_TRUE(l.inside);
        EXPECT_EQ(l.site[0], i);
        EXPECT_EQ(l.weight[0], 1);
    }
    const HoleTriangulation square({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    for (const Point2& p : {Point2{3, 0}, {8, 5}, {4, 4}}) {
        EXPECT_TRUE(locate(square, p).inside);
        EXPECT_NEAR(distance(place_of(locate(square, p), square.sites()), p), 0, 1e-15);
    }
}

TEST(HoleTriangulation, keeps_all_holes_of_the_rim_of_a_turned_grid_on_its_hull) {
    constexpr int kSide = 9;
    for (double degrees = 0; degrees < 90; degrees += 3.7) {
        const HoleTriangulation holes(turned_grid(kSide, degrees));
        EXPECT_EQ(holes.hull_edges().size(), 4u * (kSide - 1)) << degrees;
        std::set<std::uint32_t> rim;
        for (const auto& [a, b] : holes.hull_edges()) {
            rim.insert(a);
            EXPECT_NEAR(distance(holes.sites()[a], holes.sites()[b]), 25, 1e-6) << degrees;
        }
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            const bool on_rim =
                i % kSide == 0 || i % kSide == kSide - 1 || i < kSide || i >= kSide * (kSide - 1);
            EXPECT_EQ(rim.contains(i), on_rim) << degrees << " site " << i;
        }
        EXPECT_EQ(holes.triangles().size(), 2u * (kSide - 1) * (kSide - 1)) << degrees;
        expect_sound_hull(holes);
    }
}

TEST(HoleTriangulation, peels_flat_triangles_off_the_hull_up_to_the_limit) {
    const std::vector<Point2> sites{{0, 0}, {100, 0}, {50, 2}, {50, 60}};
    EXPECT_EQ(HoleTriangulation(sites).hull_edges().size(), 3u);
    const HoleTriangulation peeled(sites, 0.05);
    EXPECT_EQ(peeled.hull_edges().size(), 4u);
    EXPECT_EQ(peeled.triangles().size(), 2u);
    expect_sound_hull(peeled);
    const PlanLocation l = locate(peeled, {50, 1});
    EXPECT_FALSE(l.inside);
    EXPECT_EQ(peeled.neighbours()[0], (std::vector<std::uint32_t>{2, 3}));
}

TEST(HoleTriangulation, one_site_is_everywhere) {
    const HoleTriangulation one({{3, 4}});
    EXPECT_TRUE(one.is_flat());
    EXPECT_TRUE(one.hull_edges().empty());
    const PlanLocation l = locate(one, {-7, 99});
    EXPECT_EQ(l.site[0], 0u);
    EXPECT_EQ(l.weight[0], 1);
    EXPECT_EQ(one.neighbours(), (std::vector<std::vector<std::uint32_t>>{{}}));
    EXPECT_EQ(natural_places(one, {{1, 1}})[0].weights.size(), 1u);
}

TEST(HoleTriangulation, collinear_sites_are_a_chain_in_order) {
    const HoleTriangulation chain({{2, 2}, {0, 0}, {6, 6}, {4, 4}});
    EXPECT_TRUE(chain.is_flat());
    ASSERT_EQ(chain.hull_edges().size(), 6u) << "there and back again";
    for (std::size_t e = 0; e < 6; ++e)
        EXPECT_EQ(chain.hull_edges()[e][1], chain.hull_edges()[(e + 1) % 6][0]);
    for (std::size_t e = 0; e < 6; ++e) {
        const Point2 out = chain.outward(e);
        EXPECT_NEAR(out.x + out.y, 0, 1e-14) << "square to the chain";
        EXPECT_NEAR(std::hypot(out.x, out.y), 1, 1e-14);
        const Point2 &a = chain.sites()[chain.hull_edges()[e][0]],
                     &b = chain.sites()[chain.hull_edges()[e][1]];
        EXPECT_LT(turn(a, b, {a.x + out.x, a.y + out.y}), 0);
    }
    // Between 2,2 and 4,4, a quarter of the way, whatever the distance from the line.
    for (const double off : {0.0, 1.0, -30.0}) {
        const PlanLocation l = locate(chain, {2.5 + off, 2.5 - off});
        EXPECT_NEAR(distance(place_of(l, chain.sites()), {2.5, 2.5}), 0, 1e-12);
        EXPECT_FALSE(l.inside);
    }
    EXPECT_EQ(place_of(locate(chain, {-5, -5}), chain.sites()), (Point2{0, 0})) << "beyond its end";
    EXPECT_EQ(place_of(locate(chain, {50, 50}), chain.sites()), (Point2{6, 6}));
    EXPECT_EQ(chain.neighbours(), (std::vector<std::vector<std::uint32_t>>{{1, 3}, {0}, {3}, {0, 2}}));
}

TEST(HoleTriangulation, sites_in_line_but_for_rounding_are_a_chain_too) {
    std::vector<Point2> sites;
    for (int i = 0; i < 20; ++i)
        sites.push_back({5e6 + 10 * i * std::cos(0.4), 4.9e6 + 10 * i * std::sin(0.4)});
    EXPECT_TRUE(HoleTriangulation(sites).is_flat());
    EXPECT_EQ(HoleTriangulation(sites).hull_edges().size(), 38u);
}

TEST(HoleTriangulation, refuses_no_sites_and_two_at_one_place) {
    EXPECT_THROW(HoleTriangulation({}), InvalidInput);
    EXPECT_THROW(HoleTriangulation({{1, 2}, {3, 4}, {1, 2}}), InvalidInput);
    EXPECT_THROW(HoleTriangulation({{1, 2}, {1, 2}}), InvalidInput);
    EXPECT_NO_THROW(HoleTriangulation({{1, 2}, {1, 2.0000000001}}));
}

TEST(HoleTriangulation, neighbours_are_mutual_and_those_of_the_triangles) {
    const HoleTriangulation holes(random_places(7, 60));
    std::vector<std::set<std::uint32_t>> expected(60);
    for (const auto& t : holes.triangles())
        for (int k = 0; k < 3; ++k) {
            expected[t[k]].insert(t[(k + 1) % 3]);
            expected[t[k]].insert(t[(k + 2) % 3]);
        }
    const auto found = holes.neighbours();
    for (std::size_t i = 0; i < 60; ++i)
        EXPECT_TRUE(std::ranges::equal(found[i], expected[i])) << "ascending, each once";
}

//! The part of a convex polygon that is closer to `a` than to `b`.
std::vector<Point2> closer_to(const std::vector<Point2>& polygon, const Point2& a, const Point2& b) {
    const auto side = [&](const Point2& p) {
        return (p.x - (a.x + b.x) / 2) * (b.x - a.x) + (p.y - (a.y + b.y) / 2) * (b.y - a.y);
    };
    std::vector<Point2> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double sp = side(p), sq = side(q);
        if (sp <= 0) result.push_back(p);
        if ((sp < 0 && sq > 0) || (sp > 0 && sq < 0)) {
            const double t = sp / (sp - sq);
            result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return result;
}

double area(const std::vector<Point2>& polygon) {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) twice += turn(polygon[0], polygon[i - 1], polygon[i]);
    return std::abs(twice) / 2;
}

// Sibson's definition word by word: insert the place among the sites; each site's share is the part of its
// old Voronoi cell that the new cell takes.
std::vector<double> sibson_coordinates(const std::vector<Point2>& sites, const Point2& p) {
    constexpr double kFar = 1e4;
    std::vector<Point2> cell{{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}};
    for (const Point2& site : sites) cell = closer_to(cell, p, site);
    for (const Point2& corner : cell)
        if (std::abs(corner.x) > kFar / 2 || std::abs(corner.y) > kFar / 2) return {};  // too far out to tell
    std::vector<double> weight;
    for (const Point2& site : sites) {
        std::vector<Point2> part = cell;
        for (const Point2& other : sites)
            if (!(other == site)) part = closer_to(part, site, other);
        weight.push_back(area(part) / area(cell));
    }
    return weight;
}

TEST(NaturalPlaces, are_the_voronoi_areas_of_sibsons_definition) {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto sites = random_places(seed, 4 + seed);
        const HoleTriangulation holes(sites);
        const auto where = random_places(seed + 50, 60);
        const auto located = holes.locate(where);
        const auto found = natural_places(holes, where);
        for (std::size_t i = 0; i < where.size(); ++i) {
            if (!located[i].inside) continue;
            const auto expected = sibson_coordinates(sites, where[i]);
            if (expected.empty()) continue;
            std::vector<double> weight(sites.size());
            for (const auto& [site, w] : found[i].weights) weight[site] = w;
            for (std::size_t s = 0; s < sites.size(); ++s)
                EXPECT_NEAR(weight[s], expected[s], 1e-7) << "seed " << seed;
            ++compared;
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(NaturalPlaces, weights_are_positive_sum_to_one_and_reproduce_the_place) {
    for (const double corner : {0.0, 5e6}) {
        auto sites = random_places(3, 80, corner, corner + 100);
        const auto where = random_places(4, 1000, corner - 20, corner + 120);
        const HoleTriangulation holes(sites);
        const auto located = holes.locate(where);
        const auto found = natural_places(holes, where);
        for (std::size_t i = 0; i < where.size(); ++i) {
            double sum = 0, x = 0, y = 0;
            std::set<std::uint32_t> seen;
            for (const auto& [site, weight] : found[i].weights) {
                EXPECT_GT(weight, 0);
                EXPECT_TRUE(seen.insert(site).second) << "each once";
                sum += weight;
                x += weight * (sites[site].x - found[i].at.x);
                y += weight * (sites[site].y - found[i].at.y);
            }
            EXPECT_NEAR(sum, 1, 1e-9);
            EXPECT_NEAR(std::hypot(x, y), 0, 1e-4);
            const Point2 expected = located[i].inside ? where[i] : place_of(located[i], sites);
            EXPECT_NEAR(distance(found[i].at, expected), 0, 1e-8);
        }
    }
}

TEST(NaturalPlaces, on_a_hull_edge_are_shared_by_its_ends) {
    const HoleTriangulation holes({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {3, 5}});
    for (const Point2& p : {Point2{2, 0}, {2, -4}}) {
        const NaturalPlace place = natural_places(holes, {p})[0];
        ASSERT_EQ(place.weights.size(), 2u);
        EXPECT_NEAR(place.weights[0].weight, 0.75, 1e-12);
        EXPECT_NEAR(place.weights[1].weight, 0.25, 1e-12);
        EXPECT_EQ(place.at, (Point2{2, 0}));
        EXPECT_EQ(place.beyond, (Point2{0, 0})) << "no extension out of the true hull";
    }
}

TEST(NaturalPlaces, in_the_middle_of_four_on_a_circle_share_evenly) {
    const HoleTriangulation holes({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    const NaturalPlace place = natural_places(holes, {{4, 4}})[0];
    ASSERT_EQ(place.weights.size(), 4u);
    for (const SiteWeight& w : place.weights) EXPECT_NEAR(w.weight, 0.25, 1e-12);
}

TEST(NaturalPlaces, at_a_site_are_that_site) {
    const auto sites = random_places(9, 40);
    const HoleTriangulation holes(sites);
    const auto found = natural_places(holes, sites);
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        ASSERT_EQ(found[i].weights.size(), 1u);
        EXPECT_EQ(found[i].weights[0].site, i);
        EXPECT_EQ(found[i].weights[0].weight, 1);
    }
}

TEST(NaturalPlaces, in_a_peeled_triangle_lead_from_the_peeled_hull_to_the_place) {
    const HoleTriangulation peeled({{0, 0}, {100, 0}, {50, 2}, {50, 60}}, 0.05);
    for (const Point2& p : {Point2{50, 1}, {20, 0.25}, {50, 0}, {33, 0}}) {
        const NaturalPlace place = natural_places(peeled, {p})[0];
        EXPECT_NEAR(place.at.x + place.beyond.x, p.x, 1e-12);
        EXPECT_NEAR(place.at.y + place.beyond.y, p.y, 1e-12);
        EXPECT_GT(std::hypot(place.beyond.x, place.beyond.y), 0);
    }
    const NaturalPlace below = natural_places(peeled, {{50, -7}})[0];
    EXPECT_NEAR(below.at.y + below.beyond.y, 0, 1e-12) << "no further than the true hull";
}

}  // namespace
}  // namespace stratareeb
