// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thickness_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stratareeb {
namespace {

constexpr double kFractions[] = {0, 0.25, 1.0 / 3, 0.5};

ThicknessField field_of(const std::vector<Point2>& sites, std::vector<std::vector<double>> thickness,
                        double fraction, InterpolatorKind kind = InterpolatorKind::Linear) {
    const auto holes = std::make_shared<const HoleTriangulation>(sites);
    return {holes, std::move(thickness), {fraction}, make_interpolator(kind, holes)};
}

struct RandomHoles {
    std::vector<Point2> sites;
    std::vector<std::vector<double>> thickness;  // of three layers, about half of them zeros
};

RandomHoles random_holes(std::uint64_t seed, std::size_t count = 40) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    RandomHoles holes;
    holes.thickness.resize(3);
    for (std::size_t i = 0; i < count; ++i) {
        holes.sites.push_back({100 * share(random), 100 * share(random)});
        for (auto& layer : holes.thickness) layer.push_back(share(random) < 0.5 ? 0 : 1 + 9 * share(random));
    }
    return holes;
}

std::vector<Point2> random_places(std::uint64_t seed, std::size_t count, double low, double high) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(low, high);
    std::vector<Point2> where(count);
    for (Point2& p : where) p = {anywhere(random), anywhere(random)};
    return where;
}

Point2 along(const Point2& a, const Point2& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

TEST(ThicknessField, share_is_exactly_one_or_zero_amid_equal_holes) {
    const auto field = field_of({{0, 0}, {7, 1}, {3, 9}}, {{2, 3, 4}, {0, 0, 0}}, 0.5);
    for (const auto& l : field.holes().locate(random_places(1, 3000, -5, 12))) {
        EXPECT_EQ(field.share(0, l), 1.0);
        EXPECT_EQ(field.share(1, l), 0.0);
    }
}

TEST(ThicknessField, share_is_linear_between_holes_that_have_a_layer_and_holes_that_lack_it) {
    const auto field = field_of({{0, 0}, {8, 0}, {0, 8}}, {{5, 0, 0}, {0, 3, 3}}, 0.5);
    for (const Point2& p : random_places(2, 500, 0, 4)) {
        const auto l = field.holes().locate(std::span(&p, 1))[0];
        const double expected = 1 - (p.x + p.y) / 8;
        EXPECT_NEAR(field.share(0, l), expected, 1e-14);
        EXPECT_NEAR(field.share(1, l), 1 - expected, 1e-14);
    }
}

TEST(ThicknessField, ends_at_the_fraction_of_every_edge) {
    constexpr double kStep = 1e-6;
    for (const double fraction : kFractions)
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const RandomHoles holes = random_holes(seed);
            const auto field =
                field_of(holes.sites, holes.thickness, fraction, InterpolatorKind::NaturalNeighbour);
            const auto neighbours = field.holes().neighbours();
            for (std::uint32_t a = 0; a < holes.sites.size(); ++a)
                for (const std::uint32_t b : neighbours[a])
                    for (std::size_t layer = 0; layer < 3; ++layer) {
                        if (field.has(layer, a) || !field.has(layer, b)) continue;
                        const Point2 &p = holes.sites[a], &q = holes.sites[b];
                        const std::vector<Point2> where{along(p, q, std::max(0.0, fraction - kStep)),
                                                        along(p, q, fraction + kStep)};
                        const auto l = field.holes().locate(where);
                        if (!l[0].inside || !l[1].inside) continue;  // on the hull, off it by rounding
                        EXPECT_EQ(field.is_present(layer, l[0]), false);
                        EXPECT_EQ(field.is_present(layer, l[1]), true);
                        const auto t = field.predict(where);
                        EXPECT_EQ(t[layer][0], 0);
                        EXPECT_GT(t[layer][1], 0);
                        EXPECT_LT(t[layer][1], 1e-4);
                    }
        }
}

// The thesis interpolates thickness with zeros where a layer is absent.
TEST(ThicknessField, with_fraction_zero_is_plain_linear_interpolation_with_zeros) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const RandomHoles holes = random_holes(seed);
        const auto field = field_of(holes.sites, holes.thickness, 0);
        const auto where = random_places(seed, 300, -20, 120);
        std::vector<SiteField> plain;
        for (const auto& layer : holes.thickness) plain.push_back({layer, {}});
        const auto expected =
            make_interpolator(InterpolatorKind::Linear, std::make_shared<HoleTriangulation>(holes.sites))
                ->predict(where, plain);
        const auto found = field.predict(where);
        for (std::size_t layer = 0; layer < 3; ++layer)
            for (std::size_t i = 0; i < where.size(); ++i)
                EXPECT_NEAR(found[layer][i], expected[layer][i], 1e-12);
    }
}

TEST(ThicknessField, falls_linearly_from_the_hole_to_the_pinch_out_line) {
    const auto field = field_of({{0, 0}, {12, 0}, {6, 10}}, {{6, 0, 6}}, 1.0 / 3);
    for (double x = 0; x <= 12; x += 0.125) {  // along the lower edge the layer ends at x = 8
        const double expected = 6 * std::max(0.0, 1 - x / 8);
        EXPECT_NEAR(field.predict(std::vector<Point2>{{x, 0}})[0][0], expected, 1e-14) << x;
    }
}

TEST(ThicknessField, is_never_negative_and_zero_exactly_beyond_the_line) {
    for (const double fraction : kFractions)
        for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour})
            for (std::uint64_t seed = 1; seed <= 25; ++seed) {
                const RandomHoles holes = random_holes(seed, 3 + seed);
                const auto field = field_of(holes.sites, holes.thickness, fraction, kind);
                const auto where = random_places(seed, 400, -30, 130);
                const auto found = field.predict(where);
                const auto located = field.holes().locate(where);
                for (std::size_t layer = 0; layer < 3; ++layer)
                    for (std::size_t i = 0; i < where.size(); ++i) {
                        ASSERT_TRUE(std::isfinite(found[layer][i]));
                        ASSERT_GE(found[layer][i], 0);
                        if (!field.is_present(layer, located[i])) {
                            ASSERT_EQ(found[layer][i], 0);
                        }
                    }
            }
}

TEST(ThicknessField, is_the_holes_own_thickness_at_the_holes) {
    for (const double fraction : kFractions)
        for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
            const RandomHoles holes = random_holes(7);
            const auto field = field_of(holes.sites, holes.thickness, fraction, kind);
            EXPECT_EQ(field.predict(holes.sites), holes.thickness);
        }
}

TEST(ThicknessField, does_not_let_zeros_pull_down_what_is_there) {
    const auto field = field_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {30, 5}}, {{4, 4, 4, 4, 0}}, 0.5,
                                InterpolatorKind::NaturalNeighbour);
    for (const Point2& p : random_places(9, 300, 0, 10))
        EXPECT_NEAR(field.predict(std::span(&p, 1))[0][0], 4, 1e-12);
}

TEST(ThicknessField, ends_between_two_holes_and_around_a_single_one) {
    const auto two = field_of({{0, 0}, {10, 0}}, {{2, 0}}, 0.5);
    const std::vector<Point2> where{{0, 0}, {2.5, 3}, {5, 0}, {7, 1}};
    const auto found = two.predict(where)[0];
    EXPECT_EQ(found[0], 2);
    EXPECT_NEAR(found[1], 1, 1e-14);
    EXPECT_EQ(found[2], 0);
    EXPECT_EQ(found[3], 0);
    const auto one = field_of({{3, 3}}, {{7}, {0}}, 0.5);
    EXPECT_EQ(one.predict(where), (std::vector<std::vector<double>>{{7, 7, 7, 7}, {0, 0, 0, 0}}));
}

}  // namespace
}  // namespace stratareeb
