// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stratareeb {

//! The n + 1 Bernstein polynomials of degree n at t in [0, 1]: C(n, k) t^k (1 - t)^(n - k). They are >= 0, add up to 1,
//! and cost O(n) at any degree: ratios of neighbours outward from the largest, then one division by their sum.
std::vector<double> bernstein_basis(std::size_t n, double t);

struct BSplineBasis {
    std::size_t first = 0;       // control point of values[0]
    std::vector<double> values;  // degree + 1 of them, >= 0, sum 1
    std::vector<double> slopes;  // d/dx, sum 0
};

//! The B-spline basis functions of a degree that are not zero at x, by the Cox-de Boor recursion.
//! \pre knots ascend; knots[degree] <= x <= knots[knots.size() - 1 - degree], and that range is not empty.
BSplineBasis bspline_basis(std::span<const double> knots, std::size_t degree, double x);

}  // namespace stratareeb
