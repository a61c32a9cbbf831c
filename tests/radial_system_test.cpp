// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/radial_system.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double rolling(const Point2& p) {
    return std::sin(7 * p.x) + std::cos(5 * p.y) * p.x;
}

RadialModel covariance_model(int drift, double diagonal = 0) {
    return {covariance_kernel({VariogramModel::Exponential, 0, 1, 1}, 0), drift, diagonal};
}

TEST(RadialSystem, knows_what_each_site_would_be_missed_by) {
    const auto at = places_over_square(1, 25);
    const auto value = values_at(at, rolling);
    for (const double diagonal : {0.0, 0.2})
        for (const RadialModel& model : {covariance_model(0, diagonal), covariance_model(2, diagonal),
                                         RadialModel{spline_kernel(0), 1, diagonal}}) {
            const auto errors = RadialSystem(at, value, {}, model).leave_one_out_errors();
            for (std::size_t i = 0; i < at.size(); ++i) {
                auto other_at = at;
                auto other_value = value;
                other_at.erase(other_at.begin() + static_cast<std::ptrdiff_t>(i));
                other_value.erase(other_value.begin() + static_cast<std::ptrdiff_t>(i));
                const RadialSystem others(other_at, other_value, {}, model);
                EXPECT_NEAR(errors[i], value[i] - others.value(at[i]), 1e-9);
            }
        }
}

// Of all sets of bounds in force, the least energy among those that meet all bounds.
TEST(RadialSystem, meets_bounds_with_the_least_energy_of_all_ways) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const auto at = places_over_square(seed, 14);
        auto value = values_at(at, rolling);
        constexpr std::size_t kBounds = 6;
        std::vector<char> at_least(14, 0);
        std::mt19937_64 random(seed);
        for (std::size_t i = 0; i < kBounds; ++i) at_least[i] = 1, value[i] += normal_number(random) * 0.5;
        const RadialModel model = covariance_model(0);
        const RadialSystem found(at, value, at_least, model);
        const auto energy = [&](const RadialSystem& s, const std::vector<double>& z) {
            double sum = 0;
            const auto w = s.weights();
            for (std::size_t i = 0; i < w.size(); ++i) sum += w[i] * z[i];
            return sum;
        };
        double least = std::numeric_limits<double>::infinity();
        for (unsigned set = 0; set < 1u << kBounds; ++set) {
            std::vector<Point2> part;
            std::vector<double> z;
            for (std::size_t i = 0; i < 14; ++i)
                if (!at_least[i] || (set >> i & 1u)) part.push_back(at[i]), z.push_back(value[i]);
            const RadialSystem one(part, z, {}, model);
            bool meets = true;
            for (std::size_t i = 0; i < kBounds; ++i) meets &= one.value(at[i]) >= value[i] - 1e-9;
            if (meets) least = std::min(least, energy(one, z));
        }
        EXPECT_NEAR(energy(found, value), least, 1e-9 * (1 + least)) << "seed " << seed;
        for (std::size_t i = 0; i < 14; ++i) {
            EXPECT_GE(found.value(at[i]), value[i] - 1e-9);
            EXPECT_TRUE(at_least[i] || std::abs(found.value(at[i]) - value[i]) < 1e-9);
        }
    }
}

TEST(RadialSystem, drops_drift_that_its_sites_can_not_tell) {
    std::vector<Point2> line;
    std::vector<double> value;
    for (int i = 0; i < 8; ++i) line.push_back({i * 0.1, i * 0.2}), value.push_back(3 + i);
    const RadialSystem along(line, value, {}, covariance_model(2));
    EXPECT_NEAR(along.value({0.15, 0.3}), 4.5, 1e-9);
    EXPECT_TRUE(std::isfinite(along.value({0.5, -0.5})));
    const RadialSystem one(std::vector<Point2>{{1, 1}}, std::vector<double>{7}, {}, covariance_model(2));
    EXPECT_NEAR(one.value({5, 5}), 7, 1e-12);
}

TEST(RadialSystem, stays_finite_where_sites_all_but_meet) {
    auto at = places_over_square(3, 20);
    for (std::size_t i = 0; i < 20; ++i) at.push_back({at[i].x + 1e-13, at[i].y});
    const auto value = values_at(at, [](const Point2& p) { return p.x > 0.5 ? 1.0 : -1.0; });
    for (const auto kernel : {VariogramModel::Gaussian, VariogramModel::Spherical}) {
        const RadialSystem s(at, value, {}, {covariance_kernel({kernel, 0, 1, 2}, 0), 1, 0});
        for (const Point2& p : places_over_square(4, 50)) EXPECT_TRUE(std::isfinite(s.value(p)));
    }
}

TEST(RadialKernel, of_a_spline_in_tension_is_made_of_the_bessel_function) {
    for (const double p : {0.3, 3.0, 40.0}) {
        const auto kernel = spline_kernel(p);
        for (const double r : {0.01, 0.1, 0.5, 0.66, 0.67, 1.0, 1.9}) {
            const double exact =
                -4 / (p * p) * (std::cyl_bessel_k(0.0, p * r) + std::log(p * r / 2) + std::numbers::egamma);
            EXPECT_NEAR(kernel->at(r), exact, 2e-11 * (1 / (p * p) + std::abs(exact))) << p << ' ' << r;
        }
        EXPECT_EQ(kernel->at(0), 0);
    }
}

TEST(RadialKernel, of_a_covariance_is_the_variogram_turned_over) {
    for (const auto model : {VariogramModel::Spherical, VariogramModel::Exponential, VariogramModel::Gaussian,
                             VariogramModel::Matern32, VariogramModel::Matern52}) {
        const Variogram v{model, 0.5, 2, 0.7};
        const auto filtered = covariance_kernel(v, 0), honoured = covariance_kernel(v, 0.1);
        for (const double h : {0.1, 0.3, 0.7, 2.0}) {
            EXPECT_NEAR(filtered->at(h), 2.5 - v.at(h), 1e-14);
            EXPECT_EQ(honoured->at(h), filtered->at(h));
        }
        EXPECT_NEAR(filtered->at(0), 2, 1e-15);
        EXPECT_NEAR(honoured->at(0), 2.5, 1e-15);
    }
}

}  // namespace
}  // namespace stratareeb
