// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reeb/span_costs.h"

namespace stratareeb {

//! A path in the unrolled toroidal graph by the row it has on each antidiagonal, from k = `start` on, where it is in column 0.
struct StairPath {
    std::ptrdiff_t start = 0;
    std::vector<std::int32_t> rows;
    double cost = 0;

    bool has(std::ptrdiff_t k) const {
        return k >= start && k < start + static_cast<std::ptrdiff_t>(rows.size());
    }
    std::int32_t row(std::ptrdiff_t k) const { return rows[static_cast<std::size_t>(k - start)]; }
};

//! The path in the toroidal graph that was unrolled from these first points.
SpanPath span_path(const StairPath& path, const SpanContours& contours, std::uint32_t first_upper,
                   std::uint32_t first_lower);

//! Let a cycle begin some steps later.
void turn(SpanPath& cycle, std::size_t steps, const SpanContours& contours);

//! Rows lo … hi per antidiagonal, from k = `first` on.
struct Corridor {
    std::ptrdiff_t first = 0;
    std::vector<std::int32_t> lo, hi;

    std::int32_t lowest(std::ptrdiff_t k) const { return lo[static_cast<std::size_t>(k - first)]; }
    std::int32_t highest(std::ptrdiff_t k) const { return hi[static_cast<std::size_t>(k - first)]; }
    std::size_t spans() const;
};

//! Finds shortest paths with one start each; keeps its working memory from one to the next.
class StairPathFinder {
 public:
    //! Paths rise `height` rows over all columns.
    StairPathFinder(const SpanCosts& costs, std::ptrdiff_t height);

    //! The shortest path from (start, 0) to (start + height, columns) in the corridor, not left of `left` and not right of
    //! `right` where these are given; a step of the lower end comes last on ties. None if there is no way through.
    std::optional<StairPath> shortest(std::ptrdiff_t start, const Corridor& corridor,
                                      const StairPath* left = nullptr, const StairPath* right = nullptr);

    std::size_t looked_at() const { return looked_at_; }  // spans, for all paths

 private:
    void bound_rows(std::ptrdiff_t start, const Corridor& corridor, const StairPath* left,
                    const StairPath* right);
    StairPath trace_back(std::ptrdiff_t start) const;

    const SpanCosts& costs_;
    std::ptrdiff_t height_;
    std::vector<double> from_,
        to_;  // costs of the antidiagonal before and of this one, by row, shifted by one
    std::vector<std::int32_t> lo_, hi_;
    std::vector<std::uint8_t> steps_;  // a bit per span
    std::vector<std::size_t> first_step_;
    std::size_t looked_at_ = 0;
};

}  // namespace stratareeb
