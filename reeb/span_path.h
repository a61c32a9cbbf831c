// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace stratareeb {

//! What a triangulation between two contours should have as little of as possible.
enum class BandCost {
    Area,        // of the triangles
    SpanLength,  // the Euclidean distance function: lengths of all spans, summed
    ParameterDistance,  // the parametric distance function: |s - t| of all spans, around the circle if the contours are closed
};

//! A monotone path in the toroidal graph, which is a triangulation: its vertices are spans from an upper to a lower point,
//! each step moves one end of the span on and leaves one triangle behind.
struct SpanPath {
    std::uint32_t upper = 0, lower = 0;        // the first span
    std::vector<std::uint8_t> upper_advances;  // per step: 1 if the upper end moves on, 0 if the lower does
    double cost = 0;
};

//! The triangles along a path, in its order, between contours of `m` upper and `n` lower points. Corners 0 … m - 1 are
//! upper, m … m + n - 1 lower points. With the upper contour above and both counter-clockwise seen from above, triangles are
//! counter-clockwise seen from outside. A step along a contour of one point leaves no triangle.
std::vector<std::array<std::uint32_t, 3>> band_triangles(const SpanPath& path, std::uint32_t m,
                                                         std::uint32_t n);

}  // namespace stratareeb
