// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace stratareeb {

constexpr std::ptrdiff_t kSweepPadding = 8;

//! x, y, z of points in three arrays.
using Axes = std::array<const double*, 3>;

//! Triangles, one per index, from half an edge and the span at its end.
struct HalfEdgesAndSpans {
    Axes half_edge, from, to;  // the span goes from `from` to `to`
};

//! The area of the first of them.
double triangle_area(const HalfEdgesAndSpans& triangles);

//! to[i] = min(up_from[i] + area of up triangle i, low_from[i] + area of low triangle i) for `count` indices; bit i of `steps`,
//! if given, says that the second is not larger. All arrays go on for kSweepPadding more, which are read, and written in `to`,
//! with no meaning. Results are the same to the last bit on all machines.
void relax_areas(const HalfEdgesAndSpans& up, const HalfEdgesAndSpans& low, const double* up_from,
                 const double* low_from, std::ptrdiff_t count, double* to, std::uint8_t* steps);

}  // namespace stratareeb
