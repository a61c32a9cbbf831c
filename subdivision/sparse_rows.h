// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stratareeb {

//! Sparse rows: row r has columns column[first[r]] up to column[first[r + 1]], and their weights.
struct SparseRows {
    std::vector<std::uint32_t> first{0}, column;
    std::vector<double> weight;

    std::size_t size() const { return first.size() - 1; }
};

//! The sum of weights times values for each row, on several threads; the same result with any number of them.
//! \pre a value for each column
std::vector<double> row_sums(const SparseRows& rows, std::span<const double> values);

}  // namespace stratareeb
