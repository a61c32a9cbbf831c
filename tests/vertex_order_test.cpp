// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_order.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace stratareeb {
namespace {

void expect_sorted_as_by_comparison(const std::vector<double>& values) {
    std::vector<std::uint32_t> expected(values.size());
    std::iota(expected.begin(), expected.end(), 0u);
    std::ranges::sort(expected, [&](std::uint32_t a, std::uint32_t b) {
        return values[a] < values[b] || (values[a] == values[b] && a < b);
    });
    const VertexOrder order = vertex_order(values);
    ASSERT_EQ(order.vertices, expected);
    for (std::uint32_t r = 0; r < expected.size(); ++r) ASSERT_EQ(order.rank[expected[r]], r);
}

//! Numbers of all forms: spread, tied, in two far clusters, nearly equal, of both signs of zero, at the ends of what doubles hold.
std::vector<double> numbers(int form, std::size_t n, std::mt19937_64& random) {
    std::vector<double> values(n);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (double& x : values) {
        switch (form) {
            case 0:
                x = unit() * 1000 - 500;
                break;
            case 1:
                x = static_cast<double>(random() % 5);
                break;
            case 2:
                x = random() % 2 ? 5e6 + unit() : unit() * 1e-9;
                break;
            case 3:
                x = 1 + static_cast<double>(random() % 9) * 0x1p-52;
                break;
            case 4:
                x = random() % 2 ? 0.0 : -0.0;
                break;
            case 5:
                x = (unit() - 0.5) * 1.7e308 * 2;
                break;
            case 6:
                x = static_cast<double>(random() % 9) * 5e-324;
                break;
            case 7:
                x = random() % 1000 ? std::exp(-40 * unit()) : 1e300;
                break;
            default:
                x = 7;
        }
    }
    return values;
}

TEST(VertexOrder, is_that_of_a_comparison_sort) {
    std::mt19937_64 random(21);
    for (int form = 0; form <= 8; ++form)
        for (const std::size_t n : {0, 1, 2, 3, 50, 2049, 20'000})
            ASSERT_NO_FATAL_FAILURE(expect_sorted_as_by_comparison(numbers(form, n, random)))
                << "form " << form << ", " << n << " values";
}

TEST(VertexOrder, is_the_same_over_several_blocks_and_threads) {
    std::mt19937_64 random(22);
    for (const std::size_t threads : {1u, 2u, 5u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        for (const int form : {0, 1, 7}) expect_sorted_as_by_comparison(numbers(form, 700'001, random));
    }
}

}  // namespace
}  // namespace stratareeb
