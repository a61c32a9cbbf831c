// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/span_costs.h"

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// The same loops for wider registers, chosen when the program starts. AVX2 alone brings no fused multiply-add, so that
// results are the same on all machines.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__)
#define STRATAREEB_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define STRATAREEB_WIDE
#endif

namespace stratareeb {

namespace {

constexpr std::ptrdiff_t kBlock = 256;  // spans whose costs are held at once, in the first-level cache

using Axes = std::array<const double*, 3>;

Axes at(const std::array<std::vector<double>, 3>& arrays, std::ptrdiff_t offset) {
    return {arrays[0].data() + offset, arrays[1].data() + offset, arrays[2].data() + offset};
}

STRATAREEB_WIDE void squared_areas(const Axes& u, const Axes& e, const Axes& l, const Axes& f,
                                   std::ptrdiff_t count, double* __restrict up, double* __restrict low) {
    const double *ux = u[0], *uy = u[1], *uz = u[2], *ex = e[0], *ey = e[1], *ez = e[2];
    const double *lx = l[0], *ly = l[1], *lz = l[2], *fx = f[0], *fy = f[1], *fz = f[2];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double x = lx[i] - ux[i], y = ly[i] - uy[i], z = lz[i] - uz[i];
        const double a = ey[i] * z - ez[i] * y, b = ez[i] * x - ex[i] * z, c = ex[i] * y - ey[i] * x;
        const double p = fy[i] * z - fz[i] * y, q = fz[i] * x - fx[i] * z, r = fx[i] * y - fy[i] * x;
        up[i] = a * a + b * b + c * c;
        low[i] = p * p + q * q + r * r;
    }
}

STRATAREEB_WIDE void squared_lengths(const Axes& u, const Axes& l, std::ptrdiff_t count,
                                     double* __restrict to) {
    const double *ux = u[0], *uy = u[1], *uz = u[2], *lx = l[0], *ly = l[1], *lz = l[2];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double x = lx[i] - ux[i], y = ly[i] - uy[i], z = lz[i] - uz[i];
        to[i] = x * x + y * y + z * z;
    }
}

void parameter_distances(const double* s, const double* t, bool closed, std::ptrdiff_t count, double* to) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double distance = std::abs(s[i] - t[i]);
        to[i] = closed ? std::min(distance, 1 - distance) : distance;
    }
}

// std::sqrt must set errno, which keeps compilers from taking two at once.
void take_roots(std::ptrdiff_t count, double* values) {
    std::ptrdiff_t i = 0;
#if defined(__SSE2__)
    for (; i + 2 <= count; i += 2) _mm_storeu_pd(values + i, _mm_sqrt_pd(_mm_loadu_pd(values + i)));
#endif
    for (; i < count; ++i) values[i] = std::sqrt(values[i]);
}

STRATAREEB_WIDE void relax(const double* __restrict up_from, const double* __restrict low_from,
                           const double* __restrict up, const double* __restrict low, std::ptrdiff_t count,
                           double* __restrict to) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double a = up_from[i] + up[i], b = low_from[i] + low[i];
        to[i] = b < a ? b : a;
    }
}

//! As above, and one bit per span: the lower end moved (on a tie too).
void relax_and_note(const double* from, const double* up, const double* low, std::ptrdiff_t count, double* to,
                    std::uint8_t* steps) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) {
        unsigned bits = 0;
        std::ptrdiff_t c = i;
        const std::ptrdiff_t end = std::min(i + 8, count);
#if defined(__SSE2__)
        for (; c + 2 <= end; c += 2) {
            const __m128d a = _mm_add_pd(_mm_loadu_pd(from + c - 1), _mm_loadu_pd(up + c));
            const __m128d b = _mm_add_pd(_mm_loadu_pd(from + c), _mm_loadu_pd(low + c));
            bits |= static_cast<unsigned>(_mm_movemask_pd(_mm_cmple_pd(b, a))) << (c - i);
            _mm_storeu_pd(to + c, _mm_min_pd(b, a));
        }
#endif
        for (; c < end; ++c) {
            const double a = from[c - 1] + up[c], b = from[c] + low[c];
            bits |= (b <= a ? 1u : 0u) << (c - i);
            to[c] = b < a ? b : a;
        }
        steps[i / 8] = static_cast<std::uint8_t>(bits);
    }
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
        for (auto& axis : places) axis.resize(count);
        for (auto& axis : edges) axis.resize(count);
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

void SpanCosts::fill_arrivals(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t count, double* up,
                              double* low) const {
    const std::ptrdiff_t slot = columns_ + 1 - k + lo;
    switch (cost_) {
        case BandCost::Area:
            squared_areas(at(upper_, lo), at(upper_edge_, lo), at(lower_, slot), at(lower_edge_, slot), count,
                          up, low);
            take_roots(count, up);
            take_roots(count, low);
            return;
        case BandCost::SpanLength:
            squared_lengths(at(upper_, lo), at(lower_, slot), count, up);
            take_roots(count, up);
            break;
        case BandCost::ParameterDistance:
            parameter_distances(upper_[0].data() + lo, lower_[0].data() + slot, closed_, count, up);
            break;
    }
    std::copy_n(up, count, low);
}

void SpanCosts::advance(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from,
                        double* to, std::uint8_t* steps) const {
    std::array<double, kBlock> up, low;
    for (std::ptrdiff_t i = lo; i <= hi; i += kBlock) {
        const std::ptrdiff_t count = std::min(kBlock, hi - i + 1);
        fill_arrivals(k, i, count, up.data(), low.data());
        if (steps)
            relax_and_note(from + i, up.data(), low.data(), count, to + i, steps + (i - lo) / 8);
        else
            relax(from + i - 1, from + i, up.data(), low.data(), count, to + i);
    }
}

void SpanCosts::retreat(std::ptrdiff_t k, std::ptrdiff_t lo, std::ptrdiff_t hi, const double* from,
                        double* to) const {
    std::array<double, kBlock + 1> up, low;
    for (std::ptrdiff_t i = lo; i <= hi; i += kBlock) {
        const std::ptrdiff_t count = std::min(kBlock, hi - i + 1);
        fill_arrivals(k + 1, i, count + 1, up.data(), low.data());
        relax(from + i + 1, from + i, up.data() + 1, low.data(), count, to + i);
    }
}

std::array<double, 2> SpanCosts::arrivals(std::ptrdiff_t i, std::ptrdiff_t j) const {
    double up = 0, low = 0;
    fill_arrivals(i + j, i, 1, &up, &low);
    return {up, low};
}

}  // namespace stratareeb
