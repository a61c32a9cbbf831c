// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/kriging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "boreholes/errors.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double rolling(const Point2& p) {
    return 10 + std::sin(7 * p.x) + std::cos(5 * p.y) * p.x;
}

struct Estimate {
    double value, deviation;
};

//! Kriging as textbooks have it: semivariances, Lagrange multipliers, one system for each place.
Estimate textbook(const std::vector<Point2>& at, const std::vector<double>& value, const Variogram& v,
                  int drift, const Point2& p) {
    const auto f = [&](const Point2& q) {
        std::vector<double> terms{1};
        if (drift >= 1) terms.insert(terms.end(), {q.x, q.y});
        if (drift >= 2) terms.insert(terms.end(), {q.x * q.x, q.x * q.y, q.y * q.y});
        return terms;
    };
    const auto n = static_cast<Eigen::Index>(at.size()), m = n + static_cast<Eigen::Index>(f(p).size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(m, m);
    Eigen::VectorXd b(m);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Point2& q = at[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < n; ++j) {
            const Point2& r = at[static_cast<std::size_t>(j)];
            A(i, j) = v.at(q.x - r.x, q.y - r.y);
        }
        b[i] = v.at(q.x - p.x, q.y - p.y);
        for (Eigen::Index k = n; k < m; ++k) A(i, k) = A(k, i) = f(q)[static_cast<std::size_t>(k - n)];
    }
    for (Eigen::Index k = n; k < m; ++k) b[k] = f(p)[static_cast<std::size_t>(k - n)];
    const Eigen::VectorXd weights = A.fullPivLu().solve(b);
    double z = 0;
    for (Eigen::Index i = 0; i < n; ++i) z += weights[i] * value[static_cast<std::size_t>(i)];
    return {z, std::sqrt(std::max(0.0, weights.dot(b)))};
}

const std::vector<Variogram> kVariograms{
    {VariogramModel::Spherical, 0, 2, 0.6},
    {VariogramModel::Exponential, 0, 1, 1.5},
    {VariogramModel::Gaussian, 0.05, 1, 0.3},
    {VariogramModel::Matern32, 0.3, 1, 0.5},
    {VariogramModel::Matern52, 0.1, 3, 0.4, 0.4, 0.6},
};

TEST(Kriging, is_what_the_textbook_solves) {
    const auto at = places_over_square(1, 40), where = places_over_square(2, 25);
    const auto value = values_at(at, rolling);
    const auto holes = std::make_shared<HoleTriangulation>(at);
    for (const Variogram& v : kVariograms)
        for (int drift = 0; drift <= 2; ++drift) {
            const Kriging kriging(holes, drift, {.variogram = v, .filter_nugget = true});
            const auto found = kriging.predict_with_deviation(where, std::vector<SiteField>{{value, {}}})[0];
            for (std::size_t i = 0; i < where.size(); ++i) {
                const Estimate expected = textbook(at, value, v, drift, where[i]);
                EXPECT_NEAR(found.value[i], expected.value, 1e-8) << name_of(v.model) << ", drift " << drift;
                EXPECT_NEAR(found.deviation[i], expected.deviation, 1e-7)
                    << name_of(v.model) << ", drift " << drift;
            }
        }
}

// The nugget's own structure ends at the median gap; where no hole is that near, the two ways of taking it agree.
TEST(Kriging, that_honours_values_is_kriging_with_a_nugget_away_from_the_holes) {
    std::vector<Point2> at;
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j) at.push_back({i + (i == 4 && j == 4 ? 0.01 : 0), double(j)});
    at[80] = {7.9, 7.3};  // so that the plan has short ways and long ones
    const Variogram v{VariogramModel::Exponential, 0.5, 1, 6};
    const auto value = values_at(at, [](const Point2& p) { return std::sin(13 * p.x + 7 * p.y * p.y); });
    // In the middle of a square the corners are 0.707 away, nearer than the gap of 1: so take a far place outside.
    const std::vector<Point2> where{{-1.2, 4.3}, {3.1, -1.4}};
    const auto honoured = predicted(InterpolatorKind::Kriging, at, value, where, {.variogram = v});
    const auto filtered =
        predicted(InterpolatorKind::Kriging, at, value, where, {.variogram = v, .filter_nugget = true});
    for (std::size_t i = 0; i < where.size(); ++i) EXPECT_NEAR(honoured[i], filtered[i], 0.02);
    EXPECT_EQ(predicted(InterpolatorKind::Kriging, at, value, at, {.variogram = v}), value);
    const auto beside =
        predicted(InterpolatorKind::Kriging, at, value, at, {.variogram = v, .filter_nugget = true});
    double largest = 0;
    for (std::size_t i = 0; i < at.size(); ++i) largest = std::max(largest, std::abs(beside[i] - value[i]));
    EXPECT_GT(largest, 0.3);
}

TEST(Kriging, leads_smoothly_into_every_hole_though_there_is_a_nugget) {
    const auto at = places_over_square(3, 60);
    const auto value = values_at(at, rolling);
    const Variogram v{VariogramModel::Matern32, 0.5, 1, 0.5};
    const auto jump = [&](double step) {
        std::vector<Point2> where;
        for (const Point2& p : at) where.push_back({p.x + step, p.y});
        const auto z = predicted(InterpolatorKind::Kriging, at, value, where, {.variogram = v});
        double largest = 0;
        for (std::size_t i = 0; i < z.size(); ++i) largest = std::max(largest, std::abs(z[i] - value[i]));
        return largest;
    };
    EXPECT_LT(jump(1e-6), 1e-3);
    EXPECT_LT(jump(1e-6), jump(1e-3) / 100);
}

TEST(Kriging, reproduces_what_its_drift_can_follow) {
    const auto at = places_over_square(4, 50), where = places_over_square(5, 50);
    const auto plane = [](const Point2& p) { return 3 - 2 * p.x + 5 * p.y; };
    const auto bowl = [&](const Point2& p) { return plane(p) + 4 * p.x * p.x - p.x * p.y + 2 * p.y * p.y; };
    const Variogram v{VariogramModel::Spherical, 0.2, 1, 0.5};
    const auto linear =
        predicted(InterpolatorKind::KrigingLinear, at, values_at(at, plane), where, {.variogram = v});
    const auto quadratic =
        predicted(InterpolatorKind::KrigingQuadratic, at, values_at(at, bowl), where, {.variogram = v});
    for (std::size_t i = 0; i < where.size(); ++i) {
        EXPECT_NEAR(linear[i], plane(where[i]), 1e-10);
        EXPECT_NEAR(quadratic[i], bowl(where[i]), 1e-9);
    }
}

// The patches of a large set have neighbours enough to be as good as all sites at once.
TEST(Kriging, in_patches_is_close_to_kriging_in_one_piece) {
    const auto at = places_over_square(6, 1000), where = places_over_square(7, 300);
    for (const auto& [model, most] : {std::pair(VariogramModel::Exponential, 0.02),
                                      {VariogramModel::Spherical, 0.02},
                                      {VariogramModel::Matern32, 0.02}}) {
        const Variogram v{model, 0.05, 1, 0.5};
        const auto value = simulated_field(at, v, 8);
        const auto holes = std::make_shared<HoleTriangulation>(at);
        const std::vector<SiteField> fields{{value, {}}};
        const auto patches =
            Kriging(holes, 0, {.variogram = v, .single_patch = 100}).predict_with_deviation(where, fields)[0];
        const auto whole = Kriging(holes, 0, {.variogram = v, .single_patch = 2000})
                               .predict_with_deviation(where, fields)[0];
        double squares = 0;
        for (std::size_t i = 0; i < where.size(); ++i) {
            squares += (patches.value[i] - whole.value[i]) * (patches.value[i] - whole.value[i]);
            EXPECT_NEAR(patches.deviation[i], whole.deviation[i], 0.05 * whole.deviation[i] + 0.01);
        }
        EXPECT_LT(std::sqrt(squares / static_cast<double>(where.size())), most) << name_of(model);
    }
}

// Second differences over a shrinking step go down with the step where slopes are continuous; a jump would make them grow.
TEST(Kriging, in_patches_has_neither_jumps_nor_creases) {
    const auto at = places_over_square(9, 1500);
    const auto value = values_at(at, rolling);
    const auto roughest = [&](double step) {
        std::vector<Point2> where;
        for (const Point2& p : places_over_square(10, 200))
            for (int k = -1; k <= 1; ++k)
                where.push_back({0.1 + 0.8 * p.x + k * step, 0.1 + 0.8 * p.y + k * step / 3});
        const auto z =
            predicted(InterpolatorKind::Kriging, at, value, where,
                      {.variogram = Variogram{VariogramModel::Matern52, 0, 1, 0.5}, .single_patch = 100});
        double largest = 0;
        for (std::size_t i = 0; i < z.size(); i += 3)
            largest = std::max(largest, std::abs(z[i] - 2 * z[i + 1] + z[i + 2]));
        return largest;
    };
    EXPECT_LT(roughest(1e-5), roughest(1e-3) / 1000);
}

TEST(Kriging, has_deviations_that_cover_what_is_found) {
    std::size_t within = 0, all = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const auto places = places_over_square(seed, 240);
        const auto field = simulated_field(places, {VariogramModel::Exponential, 0.1, 1, 0.6}, seed);
        const std::vector<Point2> at(places.begin(), places.begin() + 120),
            where(places.begin() + 120, places.end());
        const std::vector<double> value(field.begin(), field.begin() + 120);
        const auto found = Kriging(std::make_shared<HoleTriangulation>(at), 0, {})
                               .predict_with_deviation(where, std::vector<SiteField>{{value, {}}})[0];
        for (std::size_t i = 0; i < where.size(); ++i, ++all)
            within += std::abs(found.value[i] - field[120 + i]) < 1.96 * found.deviation[i];
    }
    const double share = static_cast<double>(within) / static_cast<double>(all);
    EXPECT_GT(share, 0.92);
    EXPECT_LT(share, 0.98);
}

TEST(Kriging, takes_bounds_as_what_they_are) {
    const std::vector<Point2> at{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0.5, 0.5}, {0.2, 0.7}};
    const std::vector<double> value{1, 1, 1, 1.1, 3, 0.2};
    const std::vector<char> at_least{0, 0, 0, 0, 1, 1};
    const Kriging kriging(std::make_shared<HoleTriangulation>(at), 0,
                          {.variogram = Variogram{VariogramModel::Exponential, 0, 1, 2}});
    const auto found = kriging.predict(at, std::vector<SiteField>{{value, {}, at_least}})[0];
    EXPECT_NEAR(found[4], 3, 1e-9) << "the bound lifts the surface to itself";
    EXPECT_GT(found[5], 0.9) << "a bound far below says nothing";
    const auto lifted = std::vector<char>{1, 1, 1, 1, 1, 0};
    const auto same = kriging.predict(at, std::vector<SiteField>{{value, lifted}})[0];
    for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(found[i], same[i], 1e-9);
}

TEST(Kriging, tells_the_variogram_it_uses_in_units_of_the_survey) {
    auto at = places_over_square(11, 300);
    const auto value = simulated_field(at, {VariogramModel::Exponential, 0, 1, 0.5}, 12);
    const Variogram here = Kriging(std::make_shared<HoleTriangulation>(at), 0, {}).variogram_of({value, {}});
    for (Point2& p : at) p = {5e6 + 1024 * p.x, 4e6 + 1024 * p.y};
    std::vector<double> scaled(value);
    for (double& v : scaled) v *= 4;
    const Variogram there =
        Kriging(std::make_shared<HoleTriangulation>(at), 0, {}).variogram_of({scaled, {}});
    EXPECT_EQ(here.model, there.model);
    EXPECT_NEAR(there.range, 1024 * here.range, 1e-3 * there.range);
    EXPECT_NEAR(there.sill, 16 * here.sill, 1e-3 * there.sill);
}

TEST(Kriging, refuses_variograms_that_are_none) {
    const auto holes = std::make_shared<HoleTriangulation>(places_over_square(1, 5));
    for (const Variogram& v : {Variogram{VariogramModel::Spherical, -1, 1, 1},
                               {VariogramModel::Spherical, 0, 0, 1},
                               {VariogramModel::Spherical, 0, 1, 0},
                               {VariogramModel::Spherical, 0, 1, std::nan("")}})
        EXPECT_THROW(Kriging(holes, 0, {.variogram = v}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
