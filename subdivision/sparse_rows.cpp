// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/sparse_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace stratareeb {

std::vector<double> row_sums(const SparseRows& rows, std::span<const double> values) {
    constexpr std::size_t kGrain =
        4096;  // rows a task: below that, handing out tasks costs more than the sums
    std::vector<double> sums(rows.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows.size(), kGrain), [&](const auto& range) {
        for (std::size_t r = range.begin(); r < range.end(); ++r) {
            double sum = 0;
            for (auto k = rows.first[r]; k < rows.first[r + 1]; ++k)
                sum += rows.weight[k] * values[rows.column[k]];
            sums[r] = sum;
        }
    });
    return sums;
}

}  // namespace stratareeb
