// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/band_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/polygon_triangulation.h"
#include "reeb/point_math.h"
#include "reeb/toroidal_graph.h"

namespace stratareeb {

Ring with_origin(const Ring& ring, double origin) {
    Ring result{with_origin(ring.shape, origin), ring.vertices};
    const double place = origin - std::floor(origin);
    const auto first = std::ranges::lower_bound(ring.shape.parameters, place) - ring.shape.parameters.begin();
    std::ranges::rotate(result.vertices, result.vertices.begin() + first);
    return result;
}

std::uint32_t BandSurface::add_point(const Point3& p) {
    soup_.points.push_back(p);
    return static_cast<std::uint32_t>(soup_.points.size() - 1);
}

Ring BandSurface::add_ring(SampledContour shape) {
    std::vector<std::uint32_t> vertices(shape.points.size());
    std::iota(vertices.begin(), vertices.end(), static_cast<std::uint32_t>(soup_.points.size()));
    soup_.points.insert(soup_.points.end(), shape.points.begin(), shape.points.end());
    return {std::move(shape), std::move(vertices)};
}

void BandSurface::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    if (turned) std::swap(b, c);
    soup_.triangles.push_back({a, b, c});
    parts_.push_back(part_);
}

void BandSurface::add_band(const Ring& lower, const Ring& upper, bool is_hole) {
    if (lower.vertices.size() > 2 && lower.shape.parameters == upper.shape.parameters)
        return join_equal_parameters(lower, upper, is_hole);
    const std::size_t m = upper.vertices.size(), n = lower.vertices.size();
    const bool exact = triangulation_ == BandTriangulation::Exact ||
                       (triangulation_ == BandTriangulation::Automatic && m * n <= kQuickSpans);
    BandOptions options;
    options.method = exact ? BandMethod::Exact : BandMethod::Greedy;
    const Band band = toroidal_band(upper.shape.points, lower.shape.points, options);
    const auto vertex = [&](std::uint32_t corner) {
        return corner < m ? upper.vertices[corner] : lower.vertices[corner - m];
    };
    for (const auto& [a, b, c] : band.triangles) add_triangle(vertex(a), vertex(b), vertex(c), is_hole);
}

void BandSurface::join_equal_parameters(const Ring& lower, const Ring& upper, bool is_hole) {
    const std::size_t n = lower.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = (i + 1) % n;
        const auto a = lower.vertices[i], b = lower.vertices[k], c = upper.vertices[k], d = upper.vertices[i];
        const double forward = magnitude(soup_.points[c] - soup_.points[a]),
                     backward = magnitude(soup_.points[d] - soup_.points[b]);
        if (forward <= backward) {
            add_triangle(a, b, c, is_hole);
            add_triangle(a, c, d, is_hole);
        } else {
            add_triangle(a, b, d, is_hole);
            add_triangle(b, c, d, is_hole);
        }
    }
}

void BandSurface::add_flat_cap(const Ring& ring, bool is_top, bool is_hole) {
    std::vector<Point2> corners;
    for (const Point3& p : ring.shape.points) corners.push_back({p.x, p.y});
    for (const auto& [a, b, c] : triangulate_polygon(corners))
        add_triangle(ring.vertices[a], ring.vertices[b], ring.vertices[c], is_top == is_hole);
}

}  // namespace stratareeb
