// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/natural_neighbour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace stratareeb {
namespace {

using Function = std::function<double(const Point2&)>;

std::vector<Point2> random_places(std::uint64_t seed, std::size_t count, double low, double high) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(low, high);
    std::vector<Point2> at(count);
    for (Point2& p : at) p = {anywhere(random), anywhere(random)};
    return at;
}

//! Random sites and the corners of the unit square.
std::vector<Point2> unit_sites(std::uint64_t seed, std::size_t count) {
    auto sites = random_places(seed, count, 0, 1);
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0}) sites.push_back({x, y});
    return sites;
}

std::vector<double> values(const std::vector<Point2>& sites, const Function& f) {
    std::vector<double> result;
    for (const Point2& p : sites) result.push_back(f(p));
    return result;
}

std::vector<double> predict(InterpolatorKind kind, const std::vector<Point2>& sites,
                            const std::vector<double>& value, const std::vector<Point2>& where,
                            const std::vector<char>& use = {}) {
    return make_interpolator(kind, std::make_shared<HoleTriangulation>(sites))
        ->predict(where, std::vector<SiteField>{{value, use}})[0];
}

std::vector<double> natural(const std::vector<Point2>& sites, const std::vector<double>& value,
                            const std::vector<Point2>& where, const std::vector<char>& use = {}) {
    return predict(InterpolatorKind::NaturalNeighbour, sites, value, where, use);
}

TEST(NaturalNeighbour, reproduces_planes) {
    const auto plane = [](const Point2& p) { return 3 - 2 * p.x + 0.5 * p.y; };
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto sites = unit_sites(seed, 5 * seed), where = random_places(seed + 20, 500, 0, 1);
        const auto found = natural(sites, values(sites, plane), where);
        for (std::size_t i = 0; i < where.size(); ++i)
            EXPECT_NEAR(found[i], plane(where[i]), 1e-12) << "seed " << seed;
    }
}

TEST(NaturalNeighbour, passes_through_the_sites_exactly) {
    const auto sites = unit_sites(4, 150);
    const auto value = values(sites, [](const Point2& p) { return std::sin(40 * p.x) / 7 + p.y; });
    EXPECT_EQ(natural(sites, value, sites), value);
}

TEST(NaturalNeighbour, is_continuous_at_the_sites) {
    const auto sites = unit_sites(5, 60);
    const auto value = values(sites, [](const Point2& p) { return std::sin(9 * p.x) * std::cos(7 * p.y); });
    for (std::size_t s = 0; s + 4 < sites.size(); ++s)
        for (const Point2& step : {Point2{1, 0}, {-1, 0}, {0.6, 0.8}, {0, -1}}) {
            constexpr double kStep = 1e-9;
            const auto z =
                natural(sites, value, {{sites[s].x + kStep * step.x, sites[s].y + kStep * step.y}});
            EXPECT_NEAR(z[0], value[s], 1e-6);
        }
}

TEST(NaturalNeighbour, converges_faster_than_linearly_on_smooth_functions) {
    const auto smooth = [](const Point2& p) { return std::sin(3 * p.x + 1) * std::cos(2 * p.y); };
    std::vector<Point2> where;
    for (const Point2& p : random_places(77, 2000, 0.2, 0.8)) where.push_back(p);
    std::vector<double> natural_error, linear_error;
    for (const int side : {6, 11, 21, 41}) {
        std::mt19937_64 random(static_cast<std::uint64_t>(side));
        std::uniform_real_distribution<double> jitter(-0.3, 0.3);
        std::vector<Point2> sites;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const bool rim = i == 0 || j == 0 || i == side - 1 || j == side - 1;
                const double dx = rim ? 0 : jitter(random), dy = rim ? 0 : jitter(random);
                sites.push_back({(i + dx) / (side - 1), (j + dy) / (side - 1)});
            }
        const auto rms = [&](InterpolatorKind kind) {
            const auto found = predict(kind, sites, values(sites, smooth), where);
            double sum = 0;
            for (std::size_t i = 0; i < where.size(); ++i) sum += std::pow(found[i] - smooth(where[i]), 2);
            return std::sqrt(sum / static_cast<double>(where.size()));
        };
        natural_error.push_back(rms(InterpolatorKind::NaturalNeighbour));
        linear_error.push_back(rms(InterpolatorKind::Linear));
    }
    for (std::size_t k = 0; k + 1 < natural_error.size(); ++k)
        EXPECT_LT(natural_error[k + 1], natural_error[k] / 3) << "half the spacing";
    for (std::size_t k = 0; k < natural_error.size(); ++k) EXPECT_LT(natural_error[k], linear_error[k]);
}

//! Shares of the way from a to b at which the line crosses edges of the triangulation, or circumcircles.
std::vector<double> crossings(const HoleTriangulation& holes, const Point2& a, const Point2& b,
                              bool circles) {
    std::vector<double> result;
    const auto& s = holes.sites();
    const Point2 d{b.x - a.x, b.y - a.y};
    const auto keep = [&](double t) {
        if (t > 0.01 && t < 0.99) result.push_back(t);
    };
    for (const auto& [i, j, k] : holes.triangles()) {
        if (!circles) {
            for (const auto& [u, v] : {std::pair(i, j), {j, k}, {k, i}}) {
                const Point2 e{s[v].x - s[u].x, s[v].y - s[u].y};
                const double turn = d.x * e.y - d.y * e.x;
                const double t = ((s[u].x - a.x) * e.y - (s[u].y - a.y) * e.x) / turn;
                const double along = ((s[u].x - a.x) * d.y - (s[u].y - a.y) * d.x) / turn;
                if (along > 0.05 && along < 0.95) keep(t);
            }
            continue;
        }
        const double bx = s[j].x - s[i].x, by = s[j].y - s[i].y, cx = s[k].x - s[i].x, cy = s[k].y - s[i].y;
        const double twice = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
        const double ux = (cy * b2 - by * c2) / twice, uy = (bx * c2 - cx * b2) / twice;
        const double fx = a.x - s[i].x - ux, fy = a.y - s[i].y - uy;
        const double A = d.x * d.x + d.y * d.y, B = fx * d.x + fy * d.y,
                     C = fx * fx + fy * fy - ux * ux - uy * uy;
        if (B * B <= A * C) continue;
        keep((-B - std::sqrt(B * B - A * C)) / A);
        keep((-B + std::sqrt(B * B - A * C)) / A);
    }
    return result;
}

//! Largest difference between the slopes before and after the crossings, by steps of `step`.
double largest_jump(InterpolatorKind kind, const std::vector<Point2>& sites, const Function& f, bool circles,
                    double step) {
    const auto holes = std::make_shared<HoleTriangulation>(sites);
    const auto interpolator = make_interpolator(kind, holes);
    const auto value = values(sites, f);
    double largest = 0;
    for (double y = 0.31; y < 0.7; y += 0.0719) {
        const Point2 a{0.25, y}, b{0.75, 1 - y + 0.01};
        std::vector<Point2> where;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        for (const double t : crossings(*holes, a, b, circles))
            for (const double u : {t - step / length, t, t + step / length})
                where.push_back({a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)});
        const auto z = interpolator->predict(where, std::vector<SiteField>{{value, {}}})[0];
        for (std::size_t i = 0; i + 2 < z.size(); i += 3)
            largest = std::max(largest, std::abs(z[i + 2] - 2 * z[i + 1] + z[i]) / step);
    }
    return largest;
}

// A slope that is continuous has jumps that go to zero with the step; a crease keeps its jump.
TEST(NaturalNeighbour, has_no_creases_unlike_linear_interpolation) {
    const auto sites = unit_sites(12, 60);
    const auto f = [](const Point2& p) { return std::sin(5 * p.x) + std::cos(4 * p.y) + p.x * p.y; };
    for (const bool circles : {false, true}) {
        const auto jump = [&](double step) {
            return largest_jump(InterpolatorKind::NaturalNeighbour, sites, f, circles, step);
        };
        const double coarse = jump(1e-3), fine = jump(1e-5);
        EXPECT_LT(fine, coarse / 15) << (circles ? "circumcircles" : "edges") << ": " << coarse << " to "
                                     << fine;
    }
    const double crease = largest_jump(InterpolatorKind::Linear, sites, f, false, 1e-3),
                 same_crease = largest_jump(InterpolatorKind::Linear, sites, f, false, 1e-5);
    EXPECT_GT(crease, 0.5);
    EXPECT_NEAR(same_crease, crease, 0.2 * crease);
}

TEST(NaturalNeighbour, of_positive_values_is_positive_and_keeps_near_their_range) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const auto sites = unit_sites(seed, 30), where = random_places(seed + 40, 500, -0.3, 1.3);
        std::mt19937_64 random(seed);
        std::vector<double> value;
        for (std::size_t i = 0; i < sites.size(); ++i)
            value.push_back(random() % 2 ? 0.01 : 100 + static_cast<double>(random() % 100));
        const auto [low, high] = std::ranges::minmax(value);
        for (const double z : natural(sites, value, where)) {
            EXPECT_GE(z, low / 2) << "seed " << seed;
            EXPECT_LE(z, high + (high - low) / 2) << "seed " << seed;
        }
    }
}

TEST(NaturalNeighbour, of_equal_values_is_that_value_exactly) {
    const auto sites = unit_sites(3, 40);
    const std::vector<double> value(sites.size(), 0.1);
    for (const double z : natural(sites, value, random_places(6, 500, -1, 2))) EXPECT_EQ(z, 0.1);
}

TEST(NaturalNeighbour, takes_no_notice_of_sites_without_a_say) {
    const auto sites = unit_sites(8, 40), where = random_places(9, 400, 0, 1);
    std::vector<char> use(sites.size(), 1);
    std::vector<double> one = values(sites, [](const Point2&p) { return 2 + p.x - p.y; }), other = one;
    for (std::size_t i = 0; i < sites.size(); i += 3) use[i] = 0, other[i] = 1e12;
    const auto found = natural(sites, one, where, use);
    EXPECT_EQ(found, natural(sites, other, where, use));
    for (std::size_t i = 0; i < where.size(); ++i) {
        if (found[i] == 0) continue;  // none of the sites around has a say
        EXPECT_GT(found[i], 0.4);
        EXPECT_LT(found[i], 3.6);
    }
}

TEST(NaturalNeighbour, gives_the_closest_hull_point_outside) {
    const auto sites = unit_sites(10, 30);
    const auto value = values(sites, [](const Point2& p) { return std::sin(6 * p.x) + p.y * p.y; });
    const auto z = natural(sites, value, {{0.3, -2}, {0.3, 0}, {5, 0.7}, {1, 0.7}, {-3, -4}});
    EXPECT_NEAR(z[0], z[1], 1e-12);
    EXPECT_NEAR(z[2], z[3], 1e-12);
    EXPECT_EQ(z[4], value[sites.size() - 4]) << "the corner at the origin";
}

TEST(NaturalNeighbour, goes_on_with_its_gradient_in_flat_triangles_along_the_hull) {
    const std::vector<Point2> sites{{0, 0}, {100, 0}, {50, 2}, {50, 60}, {20, 3}, {80, 2.5}};
    const auto plane = [](const Point2& p) { return 40 + 0.1 * p.x - 0.2 * p.y; };
    const NaturalNeighbour interpolator(std::make_shared<HoleTriangulation>(sites, 0.1));
    const auto value = values(sites, plane);
    const std::vector<Point2> where{{50, 1}, {30, 0}, {70, 0.5}, {50, 0}, {10, 0.1}};
    const auto found = interpolator.predict(where, std::vector<SiteField>{{value, {}}})[0];
    for (std::size_t i = 0; i < where.size(); ++i) EXPECT_NEAR(found[i], plane(where[i]), 1e-11);
}

TEST(NaturalNeighbour, keeps_its_precision_far_from_the_origin) {
    const Point2 corner{5e6, 4.9e6};
    auto sites = unit_sites(11, 50), where = random_places(12, 400, 0.05, 0.95);
    const auto f = [](const Point2& p) { return std::sin(4 * p.x) * p.y; };
    const auto value = values(sites, f);
    for (auto* list : {&sites, &where})
        for (Point2& p : *list) p = {std::round(p.x * 4096) / 4096, std::round(p.y * 4096) / 4096};
    const auto near = natural(sites, value, where);
    for (auto* list : {&sites, &where})
        for (Point2& p : *list) p = {p.x + corner.x, p.y + corner.y};
    const auto far = natural(sites, value, where);
    for (std::size_t i = 0; i < where.size(); ++i) EXPECT_NEAR(near[i], far[i], 1e-5);
}

}  // namespace
}  // namespace stratareeb
