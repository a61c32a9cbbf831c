// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/gauss_rule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stratareeb {
namespace {

TEST(GaussRule, is_exact_up_to_its_degree_and_no_further) {
    for (std::size_t n = 1; n <= 61; ++n) {
        const GaussRule& rule = gauss_rule(n);
        ASSERT_EQ(rule.places.size(), n);
        const auto off = [&](std::size_t degree) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i)
                sum += rule.weights[i] * std::pow(rule.places[i], static_cast<double>(degree));
            return std::abs(sum - 1 / static_cast<double>(degree + 1));
        };
        for (std::size_t degree = 0; degree < 2 * n; ++degree) EXPECT_LT(off(degree), 1e-14) << n;
        if (n <= 8) {
            EXPECT_GT(off(2 * n), 1e-12) << n;
        }
    }
}

TEST(GaussRule, takes_no_other_number_of_points) {
    EXPECT_ANY_THROW(gauss_rule(62));
}

}  // namespace
}  // namespace stratareeb
