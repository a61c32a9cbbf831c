// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/reconcile_layers.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "boreholes/interpolator.h"
#include "boreholes/thickness_field.h"

namespace stratareeb {
namespace {

using Values = std::vector<double>;

//! The normal equations of the definition, in thicknesses, solved densely.
Values dense_solution(const Values& t, const Values& t_error, const Values& d, const Values& d_error) {
    const auto n = static_cast<Eigen::Index>(t.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        rows(i, i) = 1 / t_error[k];
        right[i] = t[k] / t_error[k];
        if (i == 0) continue;
        for (Eigen::Index j = 0; j <= i; ++j) rows(n + i, j) = 1 / d_error[k];
        right[n + i] = d[k] / d_error[k];
    }
    const Eigen::VectorXd x = rows.colPivHouseholderQr().solve(right);
    return {x.begin(), x.end()};
}

TEST(ReconcileLayers, is_the_least_squares_of_its_definition) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> value(1, 20), error(0.1, 10);
    for (int round = 0; round < 200; ++round) {
        const std::size_t layers = 1 + random() % 9, places = 3;
        std::vector<RatedPrediction> thickness, depth;
        for (std::size_t i = 0; i < layers; ++i) {
            thickness.push_back({Values(places), error(random)});
            depth.push_back({Values(places), error(random)});
            for (std::size_t p = 0; p < places; ++p)
                thickness[i].value[p] = value(random), depth[i].value[p] = 10.0 * (i + 1) + value(random);
        }
        const auto found = reconcile_layers(thickness, depth);
        for (std::size_t p = 0; p < places; ++p) {
            Values t, te, d, de;
            for (std::size_t i = 0; i < layers; ++i) {
                t.push_back(thickness[i].value[p]), te.push_back(thickness[i].error);
                d.push_back(depth[i].value[p]), de.push_back(depth[i].error);
            }
            const Values expected = dense_solution(t, te, d, de);
            for (std::size_t i = 0; i < layers; ++i) EXPECT_NEAR(found[i][p], expected[i], 1e-9);
        }
    }
}

TEST(ReconcileLayers, what_agrees_stays_to_the_last_bit) {
    const std::vector<RatedPrediction> thickness{{{0.1, 0.7}, 1}, {{0.2, 0.1}, 2}, {{0.3, 1e-3}, 0}};
    std::vector<RatedPrediction> depth{
        {{}, 1}, {{0.1 + 0.2, 0.7 + 0.1}, 3}, {{0.1 + 0.2 + 0.3, 0.7 + 0.1 + 1e-3}, 5}};
    const auto found = reconcile_layers(thickness, depth);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found[i], thickness[i].value);
}

TEST(ReconcileLayers, exact_depths_are_met_and_useless_ones_are_not) {
    const std::vector<RatedPrediction> thickness{{{4}, 1}, {{5}, 1}, {{6}, 1}};
    const auto sums =
        reconcile_layers(thickness, std::vector<RatedPrediction>{{{}, 1}, {{10}, 0}, {{17}, 0}});
    EXPECT_NEAR(sums[0][0] + sums[1][0], 10, 1e-9);
    EXPECT_NEAR(sums[0][0] + sums[1][0] + sums[2][0], 17, 1e-9);
    EXPECT_NEAR(sums[0][0], 4.5, 1e-9);
    const auto own =
        reconcile_layers(thickness, std::vector<RatedPrediction>{{{}, 1}, {{90}, 1e9}, {{99}, 1e9}});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(own[i][0], thickness[i].value[0], 1e-9);
}

//! Two smooth beds over a smooth base; at some holes the top between them was put in the wrong place.
struct MispickedBeds {
    std::vector<Point2> at;
    Values upper, lower;
    static double sum_at(const Point2& p) { return 60 + 8 * std::sin(p.x / 150) * std::cos(p.y / 200); }

    explicit MispickedBeds(std::uint64_t seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> place(0, 1000), slip(-12, 12);
        for (int i = 0; i < 120; ++i) {
            const Point2 p{place(random), place(random)};
            const double top = 25 + p.x / 100 + (i % 4 == 0 ? slip(random) : 0.0);
            at.push_back(p), upper.push_back(top), lower.push_back(sum_at(p) - top);
        }
    }
};

TEST(PredictLayers, a_top_in_the_wrong_place_does_not_move_the_base) {
    for (const InterpolatorKind kind : {InterpolatorKind::Kriging, InterpolatorKind::Spline}) {
        double alone = 0, together = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const MispickedBeds beds(seed);
            const auto method = make_interpolator(kind, std::make_shared<HoleTriangulation>(beds.at));
            std::vector<Point2> where;
            for (int k = 0; k < 300; ++k) where.push_back({100.0 + 45 * (k % 18), 100.0 + 48 * (k / 18)});
            const std::vector<SiteField> fields{{beds.upper, {}}, {beds.lower, {}}};
            const auto each = method->predict(where, fields), both = method->predict_layers(where, {fields});
            for (std::size_t p = 0; p < where.size(); ++p) {
                const double sum = MispickedBeds::sum_at(where[p]);
                alone += std::pow(each[0][p] + each[1][p] - sum, 2);
                together += std::pow(both[0][p] + both[1][p] - sum, 2);
            }
        }
        EXPECT_LT(std::sqrt(together), 0.75 * std::sqrt(alone)) << name_of(kind);
    }
}

//! A bed that ends in the middle of the area between two that vary: beyond its end, what is known of its depths says nothing.
TEST(PredictLayers, a_layer_that_ends_does_not_move_the_others) {
    const auto cover = [](const Point2& p) {
        return 25 + 12 * std::sin(p.x / 160) + 8 * std::cos(p.y / 130);
    };
    const auto below = [](const Point2& p) { return 30 + 9 * std::sin(p.x / 140 + 1) * std::cos(p.y / 150); };
    std::vector<Point2> where;
    for (int k = 0; k < 200; ++k) where.push_back({700.0 + 13 * (k % 20), 60.0 + 85 * (k / 20)});
    for (const InterpolatorKind kind : {InterpolatorKind::Kriging, InterpolatorKind::Spline})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            std::mt19937_64 random(seed);
            std::uniform_real_distribution<double> place(0, 1000);
            std::vector<Point2> at;
            std::vector<Values> layers(3);
            for (int i = 0; i < 150; ++i) {
                const Point2 p{place(random), place(random)};
                at.push_back(p);
                layers[0].push_back(cover(p)), layers[2].push_back(below(p));
                layers[1].push_back(p.x < 600 ? 20 + 5 * std::sin(p.x / 50) * std::sin(p.y / 70) : 0.0);
            }
            const auto holes = std::make_shared<HoleTriangulation>(at);
            const ThicknessField field(holes, layers, pinch_out_rule("half"), make_interpolator(kind, holes));
            const auto found = field.predict(where);
            const auto alone = make_interpolator(kind, holes)
                                   ->predict(where, std::vector<SiteField>{{layers[0], {}}, {layers[2], {}}});
            double together = 0, apart = 0;
            for (std::size_t p = 0; p < where.size(); ++p) {
                EXPECT_EQ(found[1][p], 0);
                together +=
                    std::pow(found[0][p] - cover(where[p]), 2) + std::pow(found[2][p] - below(where[p]), 2);
                apart +=
                    std::pow(alone[0][p] - cover(where[p]), 2) + std::pow(alone[1][p] - below(where[p]), 2);
            }
            EXPECT_LT(std::sqrt(together), 1.3 * std::sqrt(apart)) << name_of(kind) << ' ' << seed;
        }
}

//! Tapered to nothing, a layer takes no part in any correction.
TEST(ReconcileLayers, what_has_no_error_at_a_place_stays) {
    const std::vector<RatedPrediction> thickness{{{4, 4}, 1, {1, 0}}, {{0, 5}, 3, {0, 1}}, {{6, 6}, 1}};
    const std::vector<RatedPrediction> depth{{{}, 1}, {{5, 10}, 1}, {{13, 13}, 0}};
    const auto found = reconcile_layers(thickness, depth);
    EXPECT_EQ(found[1][0], 0);
    EXPECT_EQ(found[0][1], 4);
    for (std::size_t p : {0, 1}) EXPECT_NEAR(found[0][p] + found[1][p] + found[2][p], 13, 1e-12);
}

TEST(ReconcileLayers, fits_that_broke_down_count_for_nothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = HUGE_VAL;
    const std::vector<RatedPrediction> thickness{{{4}, 1}, {{5}, 1}, {{6}, 1}};
    for (const double broken : {huge, nan, 1e200}) {
        const auto found =
            reconcile_layers(thickness, std::vector<RatedPrediction>{{{}, 1}, {{90}, broken}, {{17}, 0}});
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i][0], 4 + i + 2.0 / 3, 1e-6) << broken;
        const auto all = reconcile_layers(std::vector<RatedPrediction>{{{4}, broken}, {{5}, broken}},
                                          std::vector<RatedPrediction>{{{}, 1}, {{12}, broken}});
        for (const auto& layer : all) EXPECT_TRUE(std::isfinite(layer[0])) << broken;
    }
}

TEST(PredictLayers, honours_the_holes_and_leaves_unlike_layers_alone) {
    const MispickedBeds beds(9);
    std::vector<char> some(beds.at.size(), 0);  // known at a third of the holes: too few to be reconciled
    for (std::size_t i = 0; i < some.size(); i += 3) some[i] = 1;
    for (const InterpolatorKind kind : interpolator_kinds()) {
        const auto method = make_interpolator(kind, std::make_shared<HoleTriangulation>(beds.at));
        const std::vector<SiteField> fields{{beds.upper, {}}, {beds.lower, {}}};
        const auto at_holes = method->predict_layers(beds.at, {fields});
        EXPECT_EQ(at_holes[0], beds.upper) << name_of(kind);
        EXPECT_EQ(at_holes[1], beds.lower) << name_of(kind);
        const std::vector<Point2> where{{333, 444}, {510, 90}, {-200, 1500}};
        const std::vector<SiteField> unlike{{beds.upper, {}}, {beds.lower, some}};
        EXPECT_EQ(method->predict_layers(where, {unlike}), method->predict(where, unlike)) << name_of(kind);
        for (const auto& layer : method->predict_layers(where, {fields}))
            for (const double t : layer) EXPECT_GT(t, 0) << name_of(kind);
    }
}

}  // namespace
}  // namespace stratareeb
