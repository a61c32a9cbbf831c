// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/span_path.h"

namespace stratareeb {

enum class BandMethod {
    Exact,   // the least cost over all triangulations with any first span (all but cones, see toroidal_band)
    Greedy,  // fast: the shorter of the two next spans, again and again
};

struct BandOptions {
    BandCost cost = BandCost::Area;
    BandMethod method = BandMethod::Exact;
    bool closed = true;  // false: polylines whose first points are joined, and whose last
    // Of the points, for BandCost::ParameterDistance; closed contours: modulo 1. By length along the contour if left out.
    std::span<const double> upper_parameters = {}, lower_parameters = {};
    // For greedy bands of closed contours: an upper and a lower point to start with. The first upper point and the lower one
    // nearest to it if left out.
    std::optional<std::array<std::uint32_t, 2>> first_span = {};
};

//! Triangles between two contours.
struct Band {
    SpanPath path;  // and its cost
    std::vector<std::array<std::uint32_t, 3>>
        triangles;  // see band_triangles: corners are upper points, then lower ones
};

//! Triangulate between two polygons that run the same way, by a path in their toroidal graph: its nodes are the spans from an
//! upper to a lower point, its arcs the triangles with an edge on one contour and a corner on the other, so that no triangle
//! can have anything else (thesis, 2.1.2.2). Closed contours of m and n points give a closed band of m + n triangles, open
//! polylines m + n - 2. A contour of one point gives a fan: the cap of the other contour. Points may coincide; triangles then
//! have no area. Every span is an edge of two triangles: a cheaper band of two cones that meet in one span (contours side by
//! side have one) is opened there, by the step that costs least. For time and memory see shortest_cycle; open polylines: m n steps, a bit each.
//! \throw InvalidInput
//! if a contour is empty, or a coordinate or parameter is not a finite number or too large to square twice.
Band toroidal_band(std::span<const Point3> upper, std::span<const Point3> lower,
                   const BandOptions& options = {});

//! For each point its distance from the first along the polygon, as a share of the whole; if that is 0, of their number.
std::vector<double> length_parameters(std::span<const Point3> points, bool closed);

}  // namespace stratareeb
