// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "mesh/triangle_soup.h"

namespace stratareeb {

struct BoundingBox {
    Point3 min, max;
    Point3 centre() const { return {min.x / 2 + max.x / 2, min.y / 2 + max.y / 2, min.z / 2 + max.z / 2}; }
    Point3 size() const { return {max.x - min.x, max.y - min.y, max.z - min.z}; }
};

//! The box around all points; all zero if there are none.
BoundingBox bounding_box(std::span<const Point3> points);

//! Six times the signed volume between a triangle and a place: the terms of the divergence theorem.
double six_volumes(const TriangleSoup& soup, std::uint32_t triangle, const Point3& from);

double triangle_area(const TriangleSoup& soup, std::uint32_t triangle);

//! Sides, angles and the worst triangle of a mesh. Triangles without area count, with an infinite aspect
//! ratio.
struct TriangleQuality {
    double min_edge = std::numeric_limits<double>::infinity(), max_edge = 0;
    double min_angle = std::numeric_limits<double>::infinity(), max_angle = 0;  // degrees
    double worst_aspect_ratio = 0;  // longest side over the height on it
    std::uint32_t worst_triangle = 0;
};

//! \pre there are triangles
TriangleQuality triangle_quality(const TriangleSoup& soup);

}  // namespace stratareeb
