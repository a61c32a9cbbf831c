// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/spline_basis.h"

#include <algorithm>
#include <numeric>

namespace stratareeb {
namespace {

//! The span [knots[i], knots[i + 1]) that holds x; the last one that is not empty for x at the range's end.
std::size_t knot_span(std::span<const double> knots, std::size_t degree, double x) {
    const auto first = knots.begin() + static_cast<std::ptrdiff_t>(degree);
    const auto last = knots.end() - 1 - static_cast<std::ptrdiff_t>(degree);
    const auto after = x < *last ? std::upper_bound(first, last, x) : std::lower_bound(first, last, *last);
    return static_cast<std::size_t>(after - knots.begin()) - 1;
}

//! From the basis of degree k - 1 on a span to that of degree k.
std::vector<double> raised(std::span<const double> knots, std::size_t span, std::size_t k, double x,
                           const std::vector<double>& lower) {
    std::vector<double> higher(k + 1, 0.0);
    for (std::size_t r = 0; r < k; ++r) {
        const double left = knots[span + 1 + r - k], right = knots[span + 1 + r];
        const double part = lower[r] / (right - left);  // the span itself is inside: never 0
        higher[r] += part * (right - x);
        higher[r + 1] += part * (x - left);
    }
    return higher;
}

}  // namespace

std::vector<double> bernstein_basis(std::size_t n, double t) {
    std::vector<double> basis(n + 1, 0.0);
    if (t <= 0 || t >= 1) {
        basis[t <= 0 ? 0 : n] = 1;
        return basis;
    }
    const auto size = static_cast<double>(n);
    const auto mode = std::min(n, static_cast<std::size_t>((size + 1) * t));
    basis[mode] = 1;
    for (std::size_t k = mode; k < n; ++k) {
        const auto at = static_cast<double>(k);
        basis[k + 1] = basis[k] * ((size - at) / (at + 1) * (t / (1 - t)));
    }
    for (std::size_t k = mode; k > 0; --k) {
        const auto at = static_cast<double>(k);
        basis[k - 1] = basis[k] * (at / (size - at + 1) * ((1 - t) / t));
    }
    const double sum = std::accumulate(basis.begin(), basis.end(), 0.0);
    for (double& value : basis) value /= sum;
    return basis;
}

BSplineBasis bspline_basis(std::span<const double> knots, std::size_t degree, double x) {
    const std::size_t span = knot_span(knots, degree, x);
    std::vector<double> lower, values{1.0};
    for (std::size_t k = 1; k <= degree; ++k) {
        lower = std::move(values);
        values = raised(knots, span, k, x, lower);
    }
    std::vector<double> slopes(degree + 1, 0.0);
    for (std::size_t r = 0; r < degree; ++r) {
        const double part =
            static_cast<double>(degree) * lower[r] / (knots[span + 1 + r] - knots[span + 1 + r - degree]);
        slopes[r] -= part;
        slopes[r + 1] += part;
    }
    return {span - degree, std::move(values), std::move(slopes)};
}

}  // namespace stratareeb
