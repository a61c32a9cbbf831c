// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/height_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace stratareeb {
namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

template <typename Height>
HeightSamples grid(const Height& height, double to_x = 100) {
    HeightSamples samples;
    for (double x = 0; x <= to_x; x += 2.5)
        for (double y = 0; y <= 100; y += 2.5) {
            samples.inside.push_back({.at = {x, y}, .z = height(x, y), .weight = 6.25, .tolerance = 0.05});
            samples.covered.push_back({x, std::min(x + 2.5, to_x), y, std::min(y + 2.5, 100.0)});
        }
    return samples;
}

double from_middle(const Point2& p) {
    return std::hypot(p.x - 50, p.y - 50);
}

const HeightFitOptions kFit{.finest = 2,
                            .x = CubicKnots::uniform(-5, 105, 2),
                            .y = CubicKnots::uniform(-5, 105, 2),
                            .most_functions = 900};

TEST(HeightPatch, keeps_a_plane_and_comes_close_to_waves) {
    const auto plane = fit_height_patch(grid([](double x, double y) { return 3 + 0.2 * x - 0.1 * y; }), kFit);
    EXPECT_LT(plane.off_inside, 1e-6);
    const auto waves = fit_height_patch(
        grid([](double x, double y) { return 2 * std::sin(x / 9) * std::cos(y / 11); }), kFit);
    EXPECT_LT(waves.off_inside, 0.05);
}

TEST(HeightPatch, meets_its_border_most_closely) {
    auto samples = grid([](double x, double y) { return 0.05 * x + std::sin(x / 6) * std::sin(y / 7); });
    for (int i = 0; i <= 200; ++i) {
        const double a = i * 0.03, x = 50 + 30 * std::cos(a), y = 50 + 30 * std::sin(a);
        samples.border.push_back({.at = {x, y}, .z = 0.05 * x, .tolerance = 0.01});
    }
    const auto fit = fit_height_patch(samples, kFit);
    EXPECT_LT(fit.off_border, 0.05);
    EXPECT_LT(fit.off_border, fit.off_inside / 10);
}

// A border that can't be met all along bends what is inside less where it weighs less.
TEST(HeightPatch, is_bent_less_by_a_lighter_border) {
    auto samples = grid([](double x, double) { return 0.1 * x; });
    for (int i = 0; i <= 400; ++i)
        samples.border.push_back({.at = {50, i * 0.25}, .z = 5 + 0.5 * std::sin(i / 3.0), .tolerance = 0.5});
    HeightFitOptions options{
        .x = CubicKnots::uniform(-5, 105, 12), .y = CubicKnots::uniform(-5, 105, 12), .most_functions = 0};
    const auto off = [&](double weight) {
        options.border_weight = weight;
        const HeightPatch patch = fit_height_patch(samples, options).patch;
        double inside = 0, border = 0;
        for (const auto& s : samples.inside) inside += std::abs(patch.z(s.at) - s.z);
        for (const auto& s : samples.border) border += std::pow(patch.z(s.at) - s.z, 2);
        return std::pair(inside, border);
    };
    const auto light = off(10), heavy = off(300);
    EXPECT_LT(light.first, 0.9 * heavy.first);
    EXPECT_GT(light.second, heavy.second);
}

// Noise at its edge must not make a sheet run off where nothing holds it.
TEST(HeightPatch, goes_on_gently_beyond_the_place_it_is_for) {
    auto samples = grid([](double x, double y) { return 0.1 * x + 0.3 * std::sin(1e3 * x + 77 * y); }, 60);
    samples.inside.push_back({.at = {100, 100}, .z = 10, .weight = 1e-6, .tolerance = 1});
    const CubicKnots knots = CubicKnots::uniform(-5, 105, 25);
    const auto patch = fit_height_patch(samples, {.x = knots, .y = knots, .most_functions = 0}).patch;
    for (double x = 60; x <= 75; x += 1)
        for (double y = 0; y <= 100; y += 1) EXPECT_NEAR(patch.z({x, y}), 0.1 * x, 3) << x << " " << y;
}

TEST(HeightPatch, stays_below_limits_everywhere_and_as_it_was_away_from_them) {
    const auto samples = grid([](double x, double y) { return 0.5 * std::sin(x / 5) * std::sin(y / 5); });
    HeightFitOptions options = kFit;
    options.limits = [](const CubicKnots& x, const CubicKnots& y) {
        std::vector<double> limits;
        for (const double gx : x.greville())
            for (const double gy : y.greville()) limits.push_back(from_middle({gx, gy}) < 30 ? -0.3 : kFree);
        return limits;
    };
    const auto patch = fit_height_patch(samples, options).patch;
    double highest = -kFree;
    for (double x = 0; x <= 100; x += 0.7)
        for (double y = 0; y <= 100; y += 0.7) {
            if (from_middle({x, y}) < 8) {
                EXPECT_LE(patch.z({x, y}), -0.3 + 1e-9);
                highest = std::max(highest, patch.z({x, y}));
            } else if (from_middle({x, y}) > 50) {
                EXPECT_NEAR(patch.z({x, y}), 0.5 * std::sin(x / 5) * std::sin(y / 5), 0.1);
            }
            EXPECT_GE(patch.z({x, y}), -2);  // no swing
        }
    EXPECT_NEAR(highest, -0.3, 0.01);  // no lower than need be
}

// One height that the sheet can't follow: the sheet goes below it there and stays what it was elsewhere.
TEST(HeightPatch, presses_samples_down_without_swinging) {
    auto samples = grid([](double, double) { return 0.0; });
    for (auto& s : samples.inside)
        if (from_middle(s.at) < 1) s.z = -1.1, s.highest = -1;
    HeightFitOptions options = kFit;
    options.most_functions = 150;
    options.limits = [](const CubicKnots& x, const CubicKnots& y) {
        return std::vector<double>(x.functions() * y.functions(), kFree);
    };
    const auto patch = fit_height_patch(samples, options).patch;
    std::size_t pressed = 0;
    for (const auto& s : samples.inside) {
        EXPECT_GE(patch.z(s.at), -1.5);
        if (s.highest < 0) {
            EXPECT_LE(patch.z(s.at), -1 + 1e-9);
            ++pressed;
        } else if (from_middle(s.at) > 45) {
            EXPECT_NEAR(patch.z(s.at), 0, 0.1);
        }
        EXPECT_LE(patch.z(s.at), 0.2);
    }
    EXPECT_GT(pressed, 0u);
}

TEST(HeightPatch, is_lowered_at_a_place_by_what_is_asked_and_not_beyond_its_functions) {
    auto patch = fit_height_patch(
                     grid([](double x, double y) { return 2 * std::sin(x / 9) * std::cos(y / 11); }), kFit)
                     .patch;
    const HeightPatch before = patch;
    lower_at(patch, {40, 60}, 0.5);
    EXPECT_NEAR(before.z({40, 60}) - patch.z({40, 60}), 0.5, 1e-12);
    for (double x = 0; x <= 100; x += 5)
        for (double y = 0; y <= 100; y += 5) EXPECT_LT(before.z({x, y}) - patch.z({x, y}), 0.6);
    ASSERT_GE(patch.x.spans(), 8u);
    EXPECT_EQ(before.z({95, 5}), patch.z({95, 5}));
}

// Among all changes of coefficients that tilt it so, the least one.
TEST(HeightPatch, is_tilted_at_a_place_by_the_least_change) {
    auto patch = fit_height_patch(
                     grid([](double x, double y) { return 2 * std::sin(x / 9) * std::cos(y / 11); }), kFit)
                     .patch;
    const HeightPatch before = patch;
    const Point2 at{40, 60}, direction{0.6, -0.8};
    const auto slope = [&](const HeightPatch& p) {
        const Point2 g = p.gradient(at);
        return direction.x * g.x + direction.y * g.y;
    };
    tilt_at(patch, at, direction, 0.25);
    EXPECT_NEAR(slope(patch) - slope(before), 0.25, 1e-12);
    EXPECT_EQ(before.z({95, 5}), patch.z({95, 5}));
    // The change is along the slope's gradient: what each coefficient adds to it, times one factor.
    double factor = 0;
    for (std::size_t i = 0; i < patch.coefficients.size(); ++i) {
        HeightPatch one = before;
        one.coefficients[i] += 1;
        const double adds = slope(one) - slope(before),
                     change = patch.coefficients[i] - before.coefficients[i];
        if (std::abs(adds) > 1e-6 && factor == 0) factor = change / adds;
        EXPECT_NEAR(change, factor * adds, 1e-9);
    }
    EXPECT_GT(factor, 0);
}

}  // namespace
}  // namespace stratareeb
