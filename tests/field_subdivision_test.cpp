// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/field_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

using Triangle = FieldSubdivision::Triangle;

// Triangles of an n × n grid of squares, each cut in two; vertex (i, j) is number i + j (n + 1).
std::vector<Triangle> grid(std::uint32_t n) {
    std::vector<Triangle> triangles;
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = i + j * (n + 1), b = a + 1, c = a + n + 1, d = c + 1;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    return triangles;
}

template <class Function>
std::vector<double> at_grid(std::uint32_t n, Function f) {
    std::vector<double> values;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) values.push_back(f(double(i), double(j)));
    return values;
}

double row_sum(const SparseRows& rows, std::size_t row, const std::vector<double>& values) {
    double sum = 0;
    for (auto k = rows.first[row]; k < rows.first[row + 1]; ++k)
        sum += rows.weight[k] * values[rows.column[k]];
    return sum;
}

std::vector<std::uint32_t> all(std::size_t n) {
    std::vector<std::uint32_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

TEST(FieldSubdivision, limits_do_not_depend_on_the_level_and_agree_with_the_stencils) {
    const auto sphere = shapes::uv_sphere(1, 6, 9);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> values(sphere.points.size());
    for (auto& v : values) v = uniform(random);
    const std::vector<Crease> creases{{sphere.triangles[10][0], sphere.triangles[10][1]},
                                      {sphere.triangles[40][0], sphere.triangles[40][1]}};
    std::vector<std::vector<double>> limits;
    for (int levels = 0; levels <= 4; ++levels) {
        const FieldSubdivision field(sphere.triangles, values.size(), creases, {}, levels);
        limits.push_back(field.limit(values));
        const auto rows = field.limit_stencils(all(values.size()));
        EXPECT_EQ(row_sums(rows, values).size(), values.size());
        const auto refined = field.refined(values), by_stencils = row_sums(field.stencils(), values);
        ASSERT_EQ(by_stencils.size(), field.refined_vertices());
        for (std::size_t v = 0; v < refined.size(); ++v) EXPECT_NEAR(by_stencils[v], refined[v], 1e-14);
        for (std::size_t v = 0; v < values.size(); ++v) {
            EXPECT_NEAR(limits.back()[v], limits[0][v], 1e-14);
            EXPECT_NEAR(row_sum(rows, v, values), limits[0][v], 1e-14);
        }
    }
    const FieldSubdivision deep(sphere.triangles, values.size(), creases, {}, 7);
    const auto refined = deep.refined(values);
    for (std::size_t v = 0; v < values.size(); ++v) EXPECT_NEAR(refined[v], limits[0][v], 0.02);
}

TEST(FieldSubdivision, linear_fields_stay_linear_where_corners_are_sharp) {
    constexpr std::uint32_t n = 5;
    const std::vector<SharpCorner> corners{{0}, {n}, {n * (n + 1)}, {(n + 1) * (n + 1) - 1}};
    const FieldSubdivision field(grid(n), (n + 1) * (n + 1), {}, corners, 3);
    const auto x = field.limit(at_grid(n, [](double i, double) { return i; }));
    const auto y = field.limit(at_grid(n, [](double, double j) { return j; }));
    const auto plane = field.limit(at_grid(n, [](double i, double j) { return 3 * i - 2 * j + 0.5; }));
    for (std::size_t v = 0; v < plane.size(); ++v) EXPECT_NEAR(plane[v], 3 * x[v] - 2 * y[v] + 0.5, 1e-13);
    double area = 0;
    for (const auto& [a, b, c] : field.refined_triangles()) {
        const double twice = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
        EXPECT_GT(twice, 0);
        area += twice / 2;
    }
    EXPECT_NEAR(area, n * n, 1e-12);
}

TEST(FieldSubdivision, a_quadratic_over_a_regular_grid_is_reproduced_up_to_a_constant) {
    constexpr std::uint32_t n = 8;
    const FieldSubdivision field(grid(n), (n + 1) * (n + 1), {}, {}, 2);
    const auto quadratic = [](double x, double y) { return x * x + 3 * x * y - 2 * y * y + x; };
    const auto x = field.limit(at_grid(n, [](double i, double) { return i; }));
    const auto y = field.limit(at_grid(n, [](double, double j) { return j; }));
    const auto z = field.limit(at_grid(n, quadratic));
    // Quartic box splines reproduce quadratics; a second derivative becomes a constant offset.
    double low = 1e9, high = -1e9;
    for (std::size_t v = 0; v < z.size(); ++v) {
        if (x[v] < 3 || x[v] > n - 3 || y[v] < 3 || y[v] > n - 3) continue;
        low = std::min(low, z[v] - quadratic(x[v], y[v]));
        high = std::max(high, z[v] - quadratic(x[v], y[v]));
    }
    EXPECT_NEAR(low, high, 1e-12);
    EXPECT_GT(std::abs(high), 0.01);
}

TEST(FieldSubdivision, zero_on_one_side_of_a_crease_stays_zero_there) {
    constexpr std::uint32_t n = 8;
    std::vector<Crease> creases;
    for (std::uint32_t j = 0; j < n; ++j) creases.push_back({4 + j * (n + 1), 4 + (j + 1) * (n + 1)});
    const FieldSubdivision field(grid(n), (n + 1) * (n + 1), creases, {}, 3);
    const auto control = at_grid(n, [](double i, double) { return i > 4 ? i - 4 : 0; });
    const auto x = at_grid(n, [](double i, double) { return i; });
    for (const bool limits : {false, true}) {
        const auto values = limits ? field.limit(control) : field.refined(control);
        const auto place = limits ? field.limit(x) : field.refined(x);
        for (std::size_t v = 0; v < values.size(); ++v) {
            EXPECT_GE(values[v], 0);
            EXPECT_EQ(values[v] == 0, place[v] <= 4) << v;
        }
    }
}

TEST(FieldSubdivision, stencils_are_the_published_masks) {
    // Loop's interior limit mask: 1 / (3 / (8 beta) + n) a neighbour, beta = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n.
    for (std::uint32_t n = 3; n <= 12; ++n) {
        const auto disc = shapes::disc(n, 1);
        std::uint32_t centre = 0;
        while (std::hypot(disc.points[centre].x, disc.points[centre].y) > 1e-12) ++centre;
        const FieldSubdivision field(disc.triangles, disc.points.size(), {}, {}, 1);
        const auto rows = field.limit_stencils(std::vector{centre, centre == 0 ? 1u : 0u});
        const double c = 0.375 + std::cos(2 * std::numbers::pi / n) / 4, beta = (0.625 - c * c) / n;
        const double neighbour = 1 / (3 / (8 * beta) + n);
        ASSERT_EQ(rows.first[1], n + 1);
        for (std::uint32_t k = 0; k <= n; ++k)
            EXPECT_NEAR(rows.weight[k], rows.column[k] == centre ? 1 - n * neighbour : neighbour, 1e-15);
        // An outline's limit mask is that of the cubic B-spline: 1/6, 2/3, 1/6.
        ASSERT_EQ(rows.first[2] - rows.first[1], 3u);
        double sum = 0;
        for (auto k = rows.first[1]; k < rows.first[2]; ++k) sum += rows.weight[k] * rows.weight[k];
        EXPECT_NEAR(sum, 1.0 / 36 + 4.0 / 9 + 1.0 / 36, 1e-15);
    }
}

TEST(FieldSubdivision, children_of_a_triangle_follow_one_another) {
    const auto disc = shapes::disc(7, 1);
    const FieldSubdivision field(disc.triangles, disc.points.size(), {}, {}, 2);
    const auto children = field.refined_triangles();
    ASSERT_EQ(children.size(), 16 * disc.triangles.size());
    for (std::size_t t = 0; t < disc.triangles.size(); ++t) {
        // Barycentric coordinates as fields: linear subdivision of one triangle alone keeps its own corners in its own children.
        std::vector<std::uint32_t> used;
        for (std::size_t c = 16 * t; c < 16 * (t + 1); ++c)
            used.insert(used.end(), children[c].begin(), children[c].end());
        for (const auto corner : disc.triangles[t])
            EXPECT_EQ(std::count(used.begin(), used.end(), corner), 1);
    }
}

}  // namespace
}  // namespace stratareeb
