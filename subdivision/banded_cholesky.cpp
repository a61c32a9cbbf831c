// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/banded_cholesky.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace stratareeb {
namespace {

constexpr std::size_t kBlock = 48;

using Block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

Eigen::Index index(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

}  // namespace

BandedCholesky::BandedCholesky(std::size_t size, std::size_t reach)
    : size_(size), reach_(reach), stride_(reach + kBlock), band_(size * stride_, 0) {}

std::size_t BandedCholesky::width_of(std::size_t first) const {
    return std::min(kBlock, size_ - first);
}

std::size_t BandedCholesky::below(std::size_t end) const {
    return std::min(reach_, size_ - end);
}

// A step of one column and row lies stride - 1 further: a block of the band is a dense matrix with that stride.
bool BandedCholesky::factorize() {
    const Eigen::OuterStride<> stride(index(stride_ - 1));
    for (std::size_t first = 0; first < size_; first += kBlock) {
        const std::size_t width = width_of(first), end = first + width, rows = below(end);
        Block diagonal(&at(first, first), index(width), index(width), stride);
        const Eigen::LLT<Eigen::MatrixXd> factor(diagonal.triangularView<Eigen::Lower>().toDenseMatrix());
        if (factor.info() != Eigen::Success) return false;
        diagonal.triangularView<Eigen::Lower>() = factor.matrixLLT();
        if (rows == 0) continue;
        Block left(&at(end, first), index(rows), index(width), stride);
        factor.matrixL().transpose().solveInPlace<Eigen::OnTheRight>(left);
        Block rest(&at(end, end), index(rows), index(rows), stride);
        rest.selfadjointView<Eigen::Lower>().rankUpdate(left, -1);
    }
    return true;
}

void BandedCholesky::solve_in_place(std::span<double> right_side) const {
    Eigen::Map<Eigen::VectorXd> right(right_side.data(), index(right_side.size()));
    const Eigen::OuterStride<> stride(index(stride_ - 1));
    const auto block = [&](std::size_t row, std::size_t column, std::size_t rows, std::size_t columns) {
        return Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>(
            &band_[column * stride_ + (row - column)], index(rows), index(columns), stride);
    };
    for (std::size_t first = 0; first < size_; first += kBlock) {
        const std::size_t width = width_of(first), end = first + width, rows = below(end);
        auto here = right.segment(index(first), index(width));
        block(first, first, width, width).triangularView<Eigen::Lower>().solveInPlace(here);
        if (rows > 0)
            right.segment(index(end), index(rows)).noalias() -= block(end, first, rows, width) * here;
    }
    for (std::size_t blocks = (size_ + kBlock - 1) / kBlock; blocks > 0; --blocks) {
        const std::size_t first = (blocks - 1) * kBlock, width = width_of(first), end = first + width,
                          rows = below(end);
        auto here = right.segment(index(first), index(width));
        if (rows > 0)
            here.noalias() -=
                block(end, first, rows, width).transpose() * right.segment(index(end), index(rows));
        block(first, first, width, width).transpose().triangularView<Eigen::Upper>().solveInPlace(here);
    }
}

}  // namespace stratareeb
