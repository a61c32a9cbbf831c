// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/area_sweep.h"

#include <cmath>

// Four spans at once, in registers as wide as the machine has: the choice is made when the program starts. AVX2 alone brings no
// fused multiply-add, so that all round alike.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define STRATAREEB_FOUR_AT_ONCE
#include <emmintrin.h>
#endif

namespace stratareeb {

namespace {

constexpr std::ptrdiff_t kFewSpans = 2;  // that are faster one by one than with meaningless ones

double area(const HalfEdgesAndSpans& s, std::ptrdiff_t i) {
    const double x = s.to[0][i] - s.from[0][i], y = s.to[1][i] - s.from[1][i], z = s.to[2][i] - s.from[2][i];
    const double ex = s.half_edge[0][i], ey = s.half_edge[1][i], ez = s.half_edge[2][i];
    const double a = ey * z - ez * y, b = ez * x - ex * z, c = ex * y - ey * x;
    return std::sqrt(a * a + b * b + c * c);
}

//! One span; its bit.
unsigned relax_one(const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low, const double* up_from,
                   const double* low_from, std::ptrdiff_t i, double* to) {
    const double a = up_from[i] + area(up, i), b = low_from[i] + area(low, i);
    to[i] = b < a ? b : a;
    return b <= a ? 1 : 0;
}

#ifdef STRATAREEB_FOUR_AT_ONCE

using Four = double __attribute__((vector_size(32)));
using FourAnywhere = double __attribute__((vector_size(32), aligned(8), may_alias));

// Vectors go in and out by reference: registers for them depend on the machine.
#define STRATAREEB_INLINE [[gnu::always_inline]] inline

STRATAREEB_INLINE void load(const double* from, Four& to) {
    to = *reinterpret_cast<const FourAnywhere*>(from);
}

STRATAREEB_INLINE void take_roots(Four& values) {
    const __m128d first = _mm_sqrt_pd(__builtin_shufflevector(values, values, 0, 1));
    const __m128d second = _mm_sqrt_pd(__builtin_shufflevector(values, values, 2, 3));
    values = __builtin_shufflevector(first, second, 0, 1, 2, 3);
}

STRATAREEB_INLINE void four_areas(const HalfEdgesAndSpans& s, std::ptrdiff_t i, Four& result) {
    Four x, y, z, other, ex, ey, ez;
    load(s.to[0] + i, x), load(s.from[0] + i, other), x -= other;
    load(s.to[1] + i, y), load(s.from[1] + i, other), y -= other;
    load(s.to[2] + i, z), load(s.from[2] + i, other), z -= other;
    load(s.half_edge[0] + i, ex), load(s.half_edge[1] + i, ey), load(s.half_edge[2] + i, ez);
    const Four a = ey * z - ez * y, b = ez * x - ex * z, c = ex * y - ey * x;
    result = a * a + b * b + c * c;
    take_roots(result);
}

STRATAREEB_INLINE unsigned relax_four(const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low,
                                      const double* up_from, const double* low_from, std::ptrdiff_t i,
                                      double* to) {
    Four a, b, from;
    four_areas(up, i, a);
    load(up_from + i, from), a += from;
    four_areas(low, i, b);
    load(low_from + i, from), b += from;
    *reinterpret_cast<FourAnywhere*>(to + i) = b < a ? b : a;
    const Four lower = reinterpret_cast<Four>(b <= a);
    return static_cast<unsigned>(_mm_movemask_pd(__builtin_shufflevector(lower, lower, 0, 1))) |
           static_cast<unsigned>(_mm_movemask_pd(__builtin_shufflevector(lower, lower, 2, 3))) << 2;
}

__attribute__((target_clones("avx2", "default"))) void relax_eights(
    const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low, const double* up_from, const double* low_from,
    std::ptrdiff_t count, double* to, std::uint8_t* steps) {
    for (std::ptrdiff_t i = 0; i + 8 <= count; i += 8) {
        const unsigned bits = relax_four(up, low, up_from, low_from, i, to) |
                              relax_four(up, low, up_from, low_from, i + 4, to) << 4;
        if (steps) steps[i / 8] = static_cast<std::uint8_t>(bits);
    }
}

#else

void relax_eights(const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low, const double* up_from,
                  const double* low_from, std::ptrdiff_t count, double* to, std::uint8_t* steps) {
    for (std::ptrdiff_t i = 0; i + 8 <= count; i += 8) {
        unsigned bits = 0;
        for (std::ptrdiff_t k = 0; k < 8; ++k) bits |= relax_one(up, low, up_from, low_from, i + k, to) << k;
        if (steps) steps[i / 8] = static_cast<std::uint8_t>(bits);
    }
}

#endif

}  // namespace

double triangle_area(const HalfEdgesAndSpans& triangles) {
    return area(triangles, 0);
}

void relax_areas(const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low, const double* up_from,
                 const double* low_from, std::ptrdiff_t count, double* to, std::uint8_t* steps) {
    const std::ptrdiff_t left_over = count % 8;
    if (left_over > kFewSpans) count += 8 - left_over;
    relax_eights(up, low, up_from, low_from, count, to, steps);
    if (left_over > kFewSpans) return;
    const std::ptrdiff_t rest = count - left_over;
    unsigned bits = 0;
    for (std::ptrdiff_t i = rest; i < count; ++i)
        bits |= relax_one(up, low, up_from, low_from, i, to) << (i - rest);
    if (steps && rest < count) steps[rest / 8] = static_cast<std::uint8_t>(bits);
}

}  // namespace stratareeb
