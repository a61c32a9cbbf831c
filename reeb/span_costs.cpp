// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/span_costs.h"

#include <algorithm>
#include <cmath>

#include "reeb/area_sweep.h"

namespace stratareeb {

namespace {

Axes axes(const std::array<std::vector<double>, 3>& arrays, std::ptrdiff_t offset) {
    return {arrays[0].data() + offset, arrays[1].data() + offset, arrays[2].data() + offset};
}

}  // namespace

SpanCosts::SpanCosts(const SpanContours& contours, std::uint32_t first_upper, std::uint32_t first_lower)
    : cost_(contours.cost), closed_(contours.closed) {
    const std::size_t m = contours.upper.size(), n = contours.lower.size();
    rows_ = static_cast<std::ptrdiff_t>(closed_ ? 2 * m : m - 1);
    columns_ = static_cast<std::ptrdiff_t>(closed_ ? n : n - 1);
    const auto fill = [&](std::size_t first, std::size_t count, bool backward, std::span<const Point3> points,
                          std::span<const double> parameters, auto& places, auto& edges) {
        const std::size_t size = points.size();
        for (auto& axis : places) axis.resize(count + kSweepPadding);
        for (auto& axis : edges) axis.resize(count + kSweepPadding);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t here = (first + i) % size, before = (here + size - 1) % size;
            const std::size_t slot = backward ? count - 1 - i : i;
            const Point3 p = points[here], o = points[before];
            const std::array<double, 3> place{p.x, p.y, p.z};
            const std::array<double, 3> edge{(p.x - o.x) / 2, (p.y - o.y) / 2, (p.z - o.z) / 2};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                places[axis][slot] = place[axis];
                edges[axis][slot] = edge[axis];
            }
            if (cost_ == BandCost::ParameterDistance) places[0][slot] = parameters[here];
        }
    };
    // One more than the last row and column: a sweep's ends read the steps that lead out.
    fill(first_upper, static_cast<std::size_t>(rows_) + 2, false, contours.upper, contours.upper_parameters,
         upper_, upper_edge_);
    fill(first_lower, static_cast<std::size_t>(columns_) + 2, true, contours.lower, contours.lower_parameters,
         lower_, lower_edge_);
}

std::size_t SpanCosts::array_size() const {
    return static_cast<std::size_t>(rows_ + 3 + kSweepPadding);
}

double SpanCosts::span(std::ptrdiff_t i, std::ptrdiff_t slot) const {
    const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(slot);
    const double x = lower_[0][c] - upper_[0][r];
    if (cost_ == BandCost::ParameterDistance)
        return closed_ ? std::min(std::abs(x), 1 - std::abs(x)) : std::abs(x);
    const double y = lower_[1][c] - upper_[1][r], z = lower_[2][c] - upper_[2][r];
    return std::sqrt(x * x + y * y + z * z);
}

void SpanCosts::advance(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from,
                        double* to, std::uint8_t* steps) const {
    const std::ptrdiff_t slot = columns_ + 1 - k + lo;
    if (cost_ == BandCost::Area) {
        const Axes upper = axes(upper_, lo), lower = axes(lower_, slot);
        relax_areas({axes(upper_edge_, lo), upper, lower}, {axes(lower_edge_, slot), upper, lower},
                    from + lo - 1, from + lo, hi - lo + 1, to + lo, steps);
        return;
    }
    for (std::ptrdiff_t i = lo; i <= hi; ++i) {
        const double cost = span(i, slot + i - lo), up = from[i - 1] + cost, low = from[i] + cost;
        to[i] = low < up ? low : up;
        if (!steps) continue;
        std::uint8_t& byte = steps[(i - lo) / 8];
        const std::ptrdiff_t bit = (i - lo) % 8;
        byte = static_cast<std::uint8_t>((bit == 0 ? 0 : byte) | (low <= up ? 1 : 0) << bit);
    }
}

void SpanCosts::retreat(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from,
                        double* to) const {
    const std::ptrdiff_t slot = columns_ - k + lo;  // of antidiagonal k + 1
    if (cost_ == BandCost::Area) {
        relax_areas({axes(upper_edge_, lo + 1), axes(upper_, lo + 1), axes(lower_, slot + 1)},
                    {axes(lower_edge_, slot), axes(upper_, lo), axes(lower_, slot)}, from + lo + 1, from + lo,
                    hi - lo + 1, to + lo, nullptr);
        return;
    }
    for (std::ptrdiff_t i = lo; i <= hi; ++i)
        to[i] = std::min(from[i + 1] + span(i + 1, slot + i - lo + 1), from[i] + span(i, slot + i - lo));
}

std::array<double, 2> SpanCosts::arrivals(std::ptrdiff_t i, std::ptrdiff_t j) const {
    const std::ptrdiff_t slot = columns_ + 1 - j;
    if (cost_ != BandCost::Area) return {span(i, slot), span(i, slot)};
    const Axes upper = axes(upper_, i), lower = axes(lower_, slot);
    return {triangle_area({axes(upper_edge_, i), upper, lower}),
            triangle_area({axes(lower_edge_, slot), upper, lower})};
}

}  // namespace stratareeb
