// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/interpolator.h"

#include <gtest/gtest.h>

#include <string>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

TEST(Interpolator, has_a_kind_for_each_name) {
    EXPECT_EQ(interpolator_kind("linear"), InterpolatorKind::Linear);
    EXPECT_EQ(interpolator_kind("natural"), InterpolatorKind::NaturalNeighbour);
}

TEST(Interpolator, refuses_other_names_and_says_which_there_are) {
    for (const char* name : {"", "Linear", "natural ", "kriging"}) {
        try {
            interpolator_kind(name);
            FAIL() << name;
        } catch (const InvalidInput& error) {
            EXPECT_EQ(error.what(),
                      "unknown interpolator '" + std::string(name) + "' (expected linear or natural)");
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
    EXPECT_NEAR(two[2], 3, 1e-12);
    const auto chain = at({{0, 0}, {1, 1}, {2, 2}}, {{0, 0}, {1, 1}, {2, 2}, {1.5, 1.5}});
    EXPECT_EQ(chain[0], 2);
    EXPECT_EQ(chain[1], 4);
    EXPECT_EQ(chain[2], 8);
    EXPECT_GT(chain[3], 4);
    EXPECT_LT(chain[3], 8);
}

INSTANTIATE_TEST_SUITE_P(All, AnyInterpolator,
                         ::testing::Values(InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour));

}  // namespace
}  // namespace stratareeb
