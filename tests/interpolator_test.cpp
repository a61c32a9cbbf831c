// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/interpolator.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(Interpolator, has_a_kind_for_each_name) {
    EXPECT_EQ(interpolator_kind("linear"), InterpolatorKind::Linear);
    EXPECT_EQ(interpolator_kind("natural"), InterpolatorKind::NaturalNeighbour);
    EXPECT_EQ(interpolator_kind("kriging"), InterpolatorKind::Kriging);
    EXPECT_EQ(interpolator_kinds().size(), 9u);
    for (const InterpolatorKind kind : interpolator_kinds())
        EXPECT_EQ(interpolator_kind(name_of(kind)), kind);
}

TEST(Interpolator, refuses_other_names_and_says_which_there_are) {
    EXPECT_EQ(
        interpolator_names(),
        "linear, natural, sibson-c0, inverse-distance, spline, minimum-curvature, kriging, kriging-linear or "
        "kriging-quadratic");
    for (const char* name : {"", "Linear", "natural ", "krige"}) {
        try {
            interpolator_kind(name);
            FAIL() << name;
        } catch (const InvalidInput& error) {
            EXPECT_EQ(error.what(), "unknown interpolator '" + std::string(name) + "' (expected " +
                                        interpolator_names() + ")");
        }
    }
}

// What the interface promises, whoever keeps it.
class AnyInterpolator : public ::testing::TestWithParam<InterpolatorKind> {
 protected:
    const std::vector<Point2> sites_{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {4, 5}, {7, 3}, {2, 8}};
    const std::vector<double> value_{1, 2, 4, 3, 9, 0.1, 1.0 / 3};
    const std::unique_ptr<Interpolator> interpolator_ =
        make_interpolator(GetParam(), std::make_shared<HoleTriangulation>(sites_));
};

TEST_P(AnyInterpolator, gives_a_used_site_its_value_to_the_last_bit) {
    EXPECT_EQ(interpolator_->predict(sites_, std::vector<SiteField>{{value_, {}}})[0], value_);
}

TEST_P(AnyInterpolator, is_continuous_across_the_hull) {
    constexpr double kStep = 1e-6;
    for (double along = 0.5; along < 10; along += 0.5) {
        const std::vector<Point2> pairs{
            {along, kStep}, {along, -kStep}, {10 - kStep, along}, {10 + kStep, along}};
        const auto z = interpolator_->predict(pairs, std::vector<SiteField>{{value_, {}}})[0];
        EXPECT_NEAR(z[0], z[1], 1e-4) << along;
        EXPECT_NEAR(z[2], z[3], 1e-4) << along;
    }
}

TEST_P(AnyInterpolator, predicts_each_field_by_itself) {
    const std::vector<Point2> where{{3, 3}, {9, 9}, {1, 7}, {5.5, 4.25}, {20, -3}};
    const std::vector<double> other{5, 5, 5, 5, 5, 5, 5};
    const std::vector<char> use{1, 0, 1, 1, 0, 1, 1};
    const auto together =
        interpolator_->predict(where, std::vector<SiteField>{{value_, {}}, {other, {}}, {value_, use}});
    EXPECT_EQ(together[0], interpolator_->predict(where, std::vector<SiteField>{{value_, {}}})[0]);
    EXPECT_EQ(together[2], interpolator_->predict(where, std::vector<SiteField>{{value_, use}})[0]);
    for (const double z : together[1]) EXPECT_NEAR(z, 5, 1e-13);
}

TEST_P(AnyInterpolator, gives_zero_where_no_site_has_a_say) {
    const std::vector<char> none(sites_.size(), 0);
    const auto z = interpolator_->predict(std::vector<Point2>{{3, 3}, {4, 5}, {-5, 2}},
                                          std::vector<SiteField>{{value_, none}})[0];
    EXPECT_EQ(z, (std::vector<double>{0, 0, 0}));
}

TEST_P(AnyInterpolator, takes_no_places_and_no_fields) {
    EXPECT_TRUE(interpolator_->predict({}, std::vector<SiteField>{{value_, {}}})[0].empty());
    EXPECT_TRUE(interpolator_->predict(sites_, {}).empty());
}

TEST_P(AnyInterpolator, works_on_one_two_and_collinear_sites) {
    const std::vector<double> value{2, 4, 8};
    const auto at = [&](std::vector<Point2> sites, std::vector<Point2> where) {
        const auto n = sites.size();
        const auto interpolator =
            make_interpolator(GetParam(), std::make_shared<HoleTriangulation>(std::move(sites)));
        return interpolator->predict(where, std::vector<SiteField>{{std::span(value).first(n), {}}})[0];
    };
    EXPECT_EQ(at({{1, 1}}, {{1, 1}, {9, -4}}), (std::vector<double>{2, 2}));
    const auto two = at({{0, 0}, {4, 0}}, {{0, 0}, {4, 0}, {2, 0}});
    EXPECT_EQ(two[0], 2);
    EXPECT_EQ(two[1], 4);
    EXPECT_NEAR(two[2], 3, GetParam() == InterpolatorKind::MinimumCurvature ? 1e-6 : 1e-12);
    const auto chain = at({{0, 0}, {1, 1}, {2, 2}}, {{0, 0}, {1, 1}, {2, 2}, {1.5, 1.5}});
    EXPECT_EQ(chain[0], 2);
    EXPECT_EQ(chain[1], 4);
    EXPECT_EQ(chain[2], 8);
    EXPECT_GT(chain[3], 4);
    EXPECT_LT(chain[3], 8);
}

//! Random sites over the unit square and a rolling field with a fault through it.
struct Survey2 {
    std::vector<Point2> at;
    std::vector<double> value;
};

Survey2 random_field(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(0, 1);
    Survey2 s;
    for (std::size_t i = 0; i < count; ++i) {
        const Point2 p{std::round(anywhere(random) * 4096) / 4096,
                       std::round(anywhere(random) * 4096) / 4096};
        s.at.push_back(p);
        s.value.push_back(10 + 3 * std::sin(5 * p.x) * std::cos(4 * p.y) + (p.x + p.y > 1.2 ? 1 : 0) +
                          anywhere(random) / 3);
    }
    return s;
}

std::vector<double> predict_with(InterpolatorKind kind, const std::vector<Point2>& at,
                                 const std::vector<double>& value, const std::vector<Point2>& where,
                                 const InterpolatorOptions& options = {}) {
    return make_interpolator(kind, std::make_shared<HoleTriangulation>(at), options)
        ->predict(where, std::vector<SiteField>{{value, {}}})[0];
}

std::vector<Point2> mapped(const std::vector<Point2>& at, double scale, double angle, const Point2& shift) {
    std::vector<Point2> result;
    for (const Point2& p : at)
        result.push_back({scale * (std::cos(angle) * p.x - std::sin(angle) * p.y) + shift.x,
                          scale * (std::sin(angle) * p.x + std::cos(angle) * p.y) + shift.y});
    return result;
}

// A shift by whole numbers and a scale of a power of two change no digit of the differences.
TEST_P(AnyInterpolator, is_the_same_after_a_shift_and_a_scaling) {
    const Survey2 s = random_field(3, 80), where = random_field(4, 60);
    const auto here = predict_with(GetParam(), s.at, s.value, where.at);
    const Point2 far{5'000'000, 4'000'000};
    const auto there =
        predict_with(GetParam(), mapped(s.at, 1024, 0, far), s.value, mapped(where.at, 1024, 0, far));
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 2e-6) << i;
}

TEST_P(AnyInterpolator, turns_with_the_survey) {
    if (GetParam() == InterpolatorKind::MinimumCurvature) GTEST_SKIP() << "its grid does not turn";
    const Survey2 s = random_field(5, 80), where = random_field(6, 60);
    const auto here = predict_with(GetParam(), s.at, s.value, where.at);
    const auto turned = predict_with(GetParam(), mapped(s.at, 300, 0.7, {20, 30}), s.value,
                                     mapped(where.at, 300, 0.7, {20, 30}));
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], turned[i], 1e-7) << i;
}

// Any shift and scale: coordinates lose digits, predictions no more than that.
TEST_P(AnyInterpolator, moves_by_no_more_than_rounding_at_far_coordinates) {
    if (GetParam() == InterpolatorKind::MinimumCurvature) GTEST_SKIP() << "its grid is laid anew";
    for (const auto& [scale, shift] :
         {std::pair(777.7, Point2{5'123'456.789, 3'987'654.321}), {0.123, Point2{-17.3, 33.1}}}) {
        const Survey2 s = random_field(3, 80), where = random_field(4, 60);
        const auto here = predict_with(GetParam(), s.at, s.value, where.at);
        const auto there = predict_with(GetParam(), mapped(s.at, scale, 0, shift), s.value,
                                        mapped(where.at, scale, 0, shift));
        for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 1e-6) << i;
    }
}

TEST_P(AnyInterpolator, follows_values_that_are_scaled) {
    const Survey2 s = random_field(7, 60), where = random_field(8, 60);
    std::vector<double> doubled(s.value);
    for (double& v : doubled) v *= 1024;
    const auto one = predict_with(GetParam(), s.at, s.value, where.at);
    const auto other = predict_with(GetParam(), s.at, doubled, where.at);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(1024 * one[i], other[i], 1e-5);
}

TEST_P(AnyInterpolator, is_finite_and_bounded_on_hostile_sites) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> anywhere(0, 1);
    std::vector<std::vector<Point2>> plans(5);
    for (int i = 0; i < 40; ++i) {
        plans[0].push_back({5e6 + 1e-6 * anywhere(random), 5e6 + anywhere(random)});  // a strip far away
        plans[1].push_back(
            {i < 38 ? 1e-7 * anywhere(random) : 1e4 * anywhere(random), 0.5 * i});  // a cluster
        plans[2].push_back({double(i), 3.0 * i});                                   // a line
        plans[3].push_back({double(i % 6), double(i / 6)});                         // a grid
        plans[4].push_back({1e9 * anywhere(random), 1e-9 * anywhere(random)});
    }
    for (std::size_t k = 0; k < plans.size(); ++k) {
        std::vector<double> value;
        for (std::size_t i = 0; i < plans[k].size(); ++i) value.push_back(random() % 2 ? 0.5 : 100);
        std::vector<Point2> where;
        for (int i = 0; i < 200; ++i) {
            const Point2 &a = plans[k][random() % 40], &b = plans[k][random() % 40];
            const double t = 3 * anywhere(random) - 1;
            where.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
        for (const double z : predict_with(GetParam(), plans[k], value, where)) {
            EXPECT_GE(z, 0.25) << "plan " << k;
            EXPECT_LE(z, 150) << "plan " << k;
        }
    }
}

TEST_P(AnyInterpolator, is_byte_equal_with_one_thread_and_many) {
    const Survey2 s = random_field(9, 700), where = random_field(10, 500);
    const auto many = predict_with(GetParam(), s.at, s.value, where.at);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(predict_with(GetParam(), s.at, s.value, where.at), many);
}

TEST_P(AnyInterpolator, leaves_bounds_out_or_keeps_above_them) {
    const Survey2 s = random_field(12, 60);
    std::vector<double> value = s.value;
    std::vector<char> at_least(60, 0);
    for (std::size_t i = 0; i < 60; i += 4) at_least[i] = 1, value[i] += i % 8 == 0 ? 2 : -5;
    const auto interpolator = make_interpolator(GetParam(), std::make_shared<HoleTriangulation>(s.at));
    const auto z = interpolator->predict(s.at, std::vector<SiteField>{{value, {}, at_least}})[0];
    const bool uses_bounds = interpolator->has_deviation();
    std::vector<char> use(60);
    for (std::size_t i = 0; i < 60; ++i) use[i] = !at_least[i];
    const auto without = interpolator->predict(s.at, std::vector<SiteField>{{value, use}})[0];
    for (std::size_t i = 0; i < 60; ++i) {
        if (!at_least[i]) {
            EXPECT_EQ(z[i], value[i]);
        } else if (uses_bounds) {
            EXPECT_GE(z[i], value[i] - 1e-6) << i;
        } else {
            EXPECT_EQ(z[i], without[i]);
        }
    }
}

TEST_P(AnyInterpolator, gives_deviations_that_grow_from_zero_at_the_holes) {
    const Survey2 s = random_field(13, 60);
    const auto interpolator = make_interpolator(GetParam(), std::make_shared<HoleTriangulation>(s.at));
    const std::vector<SiteField> fields{{s.value, {}}};
    std::vector<Point2> where(s.at);
    where.push_back({1.4, 1.4});
    const auto found = interpolator->predict_with_deviation(where, fields)[0];
    EXPECT_EQ(found.value, interpolator->predict(where, fields)[0]);
    if (!interpolator->has_deviation()) {
        EXPECT_TRUE(found.deviation.empty());
        return;
    }
    for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(found.deviation[i], 0);
    EXPECT_GT(found.deviation.back(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, AnyInterpolator,
                         ::testing::ValuesIn(interpolator_kinds().begin(), interpolator_kinds().end()),
                         [](const auto& test) {
                             std::string name(name_of(test.param));
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace stratareeb
