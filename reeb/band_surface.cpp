// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/band_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

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

namespace {

//! Are those of another ring, of three points or more, among its own, none twice?
bool has_parameters_of(const Ring& ring, const Ring& other) {
    const auto &own = ring.shape.parameters, &asked = other.shape.parameters;
    return asked.size() > 2 && std::ranges::adjacent_find(own) == own.end() &&
           std::ranges::adjacent_find(asked) == asked.end() && std::ranges::includes(own, asked);
}

//! Triangles between two rings, by vertices, facing outward.
std::vector<std::array<std::uint32_t, 3>> band_between(const Ring& lower, const Ring& upper, bool exact) {
    BandOptions options;
    options.method = exact ? BandMethod::Exact : BandMethod::Greedy;
    auto triangles = toroidal_band(upper.shape.points, lower.shape.points, options).triangles;
    const std::size_t m = upper.vertices.size();
    for (auto& triangle : triangles)
        for (std::uint32_t& corner : triangle)
            corner = corner < m ? upper.vertices[corner] : lower.vertices[corner - m];
    return triangles;
}

}  // namespace

std::uint32_t BandSurface::add_point(const Point3& p) {
    soup_.points.push_back(p);
    resize_free(soup_.points.size());
    return static_cast<std::uint32_t>(soup_.points.size() - 1);
}

Ring BandSurface::add_ring(SampledContour shape) {
    std::vector<std::uint32_t> vertices(shape.points.size());
    std::iota(vertices.begin(), vertices.end(), static_cast<std::uint32_t>(soup_.points.size()));
    soup_.points.insert(soup_.points.end(), shape.points.begin(), shape.points.end());
    resize_free(soup_.points.size());
    return {std::move(shape), std::move(vertices)};
}

void BandSurface::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    if (turned) std::swap(b, c);
    soup_.triangles.push_back({a, b, c});
    parts_.push_back(part_);
}

void BandSurface::add_band(const Ring& lower, const Ring& upper, bool is_hole) {
    if (has_parameters_of(upper, lower)) return join_by_parameters(lower, upper, is_hole);
    if (has_parameters_of(lower, upper)) return join_by_parameters(upper, lower, !is_hole);
    const std::size_t spans = upper.vertices.size() * lower.vertices.size();
    const bool exact = triangulation_ == BandTriangulation::Exact ||
                       (triangulation_ == BandTriangulation::Automatic && spans <= kQuickSpans);
    for (const auto& [a, b, c] : band_between(lower, upper, exact)) add_triangle(a, b, c, is_hole);
}

bool BandSurface::add_sound_band(const Ring& lower, const Ring& upper, bool is_hole) {
    const auto triangles = band_between(lower, upper, true);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;  // of directed edges: none may come twice
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (++uses[{t[i], t[(i + 1) % 3]}] > 1) return false;
    for (const auto& [a, b, c] : triangles) add_triangle(a, b, c, is_hole);
    return true;
}

void BandSurface::join_by_parameters(const Ring& few, const Ring& many, bool turned) {
    const std::size_t n = few.vertices.size(), m = many.vertices.size();
    const auto& s = many.shape.parameters;
    std::size_t at = static_cast<std::size_t>(std::ranges::find(s, few.shape.parameters.front()) - s.begin());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        std::vector<std::uint32_t> side{many.vertices[at]};
        do {
            at = (at + 1) % m;
            side.push_back(many.vertices[at]);
        } while (s[at] != few.shape.parameters[next]);
        add_side(few.vertices[i], few.vertices[next], side, turned);
    }
}

//! Triangles between the side from a to b and the vertices beside it, those for a first.
void BandSurface::add_side(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& side,
                           bool turned) {
    const auto way = [&](std::uint32_t v, std::uint32_t w) {
        return magnitude(soup_.points[w] - soup_.points[v]);
    };
    std::size_t last = way(a, side.back()) <= way(b, side.front()) ? 1 : 0;  // that a is joined to
    if (side.size() > 2) {
        last = 1;
        for (std::size_t k = 2; k + 1 < side.size(); ++k)
            if (way(a, side[k]) + way(b, side[k]) < way(a, side[last]) + way(b, side[last])) last = k;
    }
    for (std::size_t k = 0; k < last; ++k) add_triangle(a, side[k + 1], side[k], turned);
    add_triangle(a, b, side[last], turned);
    for (std::size_t k = last; k + 1 < side.size(); ++k) add_triangle(b, side[k + 1], side[k], turned);
}

void BandSurface::add_sheet(const PlanSheet& sheet, std::vector<std::uint32_t> vertices,
                            std::uint32_t group) {
    for (std::size_t i = 0; i < sheet.added.size(); ++i) {
        vertices.push_back(add_point(sheet.added[i]));
        if (i >= sheet.critical && group != FreeVertices::kNoGroup)
            let_free(vertices.back(), Freedom::Height, group);
    }
    for (const auto& [a, b, c] : sheet.triangles) add_triangle(vertices[a], vertices[b], vertices[c], false);
}

void BandSurface::add_flat_cap(const Ring& ring, bool is_top, bool is_hole) {
    std::vector<Point2> corners;
    for (const Point3& p : ring.shape.points) corners.push_back({p.x, p.y});
    for (const auto& [a, b, c] : triangulate_polygon(corners))
        add_triangle(ring.vertices[a], ring.vertices[b], ring.vertices[c], is_top == is_hole);
}

}  // namespace stratareeb
