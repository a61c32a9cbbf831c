// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/span_path.h"

namespace stratareeb {

//! Two contours as rows and columns of a toroidal graph, or of the plain grid between two open polylines.
struct SpanContours {
    std::span<const Point3> upper, lower;
    std::span<const double> upper_parameters,
        lower_parameters;  // as many, for BandCost::ParameterDistance only
    BandCost cost = BandCost::Area;
    bool closed = true;
};

//! The toroidal graph unrolled: span (i, j) joins upper point `first_upper` + i and lower point `first_lower` + j, for rows
//! i in [0, rows()] (twice around a closed contour) and columns j in [0, columns()] (once around). Spans with equal k = i + j
//! are an antidiagonal; no two of them depend on each other, so a sweep takes them all at once.
class SpanCosts {
 public:
    SpanCosts(const SpanContours& contours, std::uint32_t first_upper, std::uint32_t first_lower);

    std::ptrdiff_t rows() const { return rows_; }
    std::ptrdiff_t columns() const { return columns_; }

    //! How long the arrays by row below must be from row -1 on, for advance and retreat.
    std::size_t array_size() const;

    //! Costs of the shortest paths to antidiagonal k, rows lo … hi, from those to k - 1, rows lo - 1 … hi (infinite where no
    //! path leads). Arrays are indexed by row. If `steps` is given, bit i - lo says that the lower end moved in the last step.
    void advance(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from, double* to,
                 std::uint8_t* steps) const;

    //! The same backward: costs of the shortest paths that start on antidiagonal k, rows lo … hi, from those of k + 1, rows
    //! lo … hi + 1.
    void retreat(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from,
                 double* to) const;

    //! The costs of the one or two steps that lead to span (i, j): the upper, the lower end moved.
    std::array<double, 2> arrivals(std::ptrdiff_t i, std::ptrdiff_t j) const;

 private:
    double span(std::ptrdiff_t i,
                std::ptrdiff_t slot) const;  // the cost of coming to it, if that is not an area

    std::ptrdiff_t rows_ = 0, columns_ = 0;
    BandCost cost_;
    bool closed_;
    // Coordinates, then half edges that arrive at the point, each axis in an array of its own; or parameters in axis 0.
    // Lower arrays run backward, so that an antidiagonal reads both forward.
    std::array<std::vector<double>, 3> upper_, upper_edge_, lower_, lower_edge_;
};

}  // namespace stratareeb
