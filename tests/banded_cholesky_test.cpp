// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/banded_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>

namespace stratareeb {
namespace {

class RandomBand : public testing::TestWithParam<unsigned> {};

// Against dense factors, from single numbers to several blocks, bands shorter and longer than a block or the matrix.
TEST_P(RandomBand, solves_as_dense_factors_do) {
    std::mt19937 random(GetParam());
    const std::size_t size = 1 + random() % 300, reach = random() % 120;
    std::uniform_real_distribution<double> number(-1, 1);
    const auto n = static_cast<Eigen::Index>(size);
    // A product of a band and itself is positive definite, and as wide.
    Eigen::MatrixXd band = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = j; i < std::min(n, j + 1 + static_cast<Eigen::Index>(reach)); ++i)
            band(i, j) = i == j ? 1.5 + number(random) : number(random) / static_cast<double>(reach + 1);
    const Eigen::MatrixXd full = band * band.transpose();
    for (int again = 0; again < 2; ++again) {
        BandedCholesky matrix(size, reach);
        for (std::size_t j = 0; j < size; ++j)
            for (std::size_t i = j; i <= std::min(size - 1, j + reach); ++i)
                matrix.at(i, j) = full(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        ASSERT_TRUE(matrix.factorize());
        const Eigen::VectorXd right = Eigen::VectorXd::NullaryExpr(n, [&] { return number(random); });
        Eigen::VectorXd x = right;
        matrix.solve_in_place({x.data(), size});
        EXPECT_LT((full * x - right).norm(), 1e-10 * right.norm());
        EXPECT_LT((x - full.llt().solve(right)).norm(), 1e-8 * x.norm());
    }
}

TEST_P(RandomBand, says_where_there_are_no_factors) {
    std::mt19937 random(GetParam());
    const std::size_t size = 2 + random() % 200, reach = 1 + random() % 60;
    BandedCholesky matrix(size, reach);
    for (std::size_t i = 0; i < size; ++i) matrix.at(i, i) = 1;
    const std::size_t bad = random() % (size - 1);
    matrix.at(bad + 1, bad) = 2;
    EXPECT_FALSE(matrix.factorize());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBand, testing::Range(0u, 60u));

}  // namespace
}  // namespace stratareeb
