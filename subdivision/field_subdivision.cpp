// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/field_subdivision.h"

namespace stratareeb {
namespace {

std::span<const std::uint32_t> flat(std::span<const FieldSubdivision::Triangle> triangles) {
    static_assert(sizeof(FieldSubdivision::Triangle) == 3 * sizeof(std::uint32_t));
    if (triangles.empty()) return {};
    return {triangles.front().data(), 3 * triangles.size()};
}

}  // namespace

FieldSubdivision::FieldSubdivision(std::span<const Triangle> triangles, std::size_t vertices,
                                   std::span<const Crease> creases,
                                   std::span<const SharpCorner> sharp_corners, int levels)
    : topology_({.scheme = SubdivisionScheme::Loop,
                 .vertices = vertices,
                 .corners = flat(triangles),
                 .creases = creases,
                 .sharp_corners = sharp_corners},
                levels) {}

std::size_t FieldSubdivision::refined_vertices() const {
    return topology_.vertex_count(topology_.levels());
}

std::vector<FieldSubdivision::Triangle> FieldSubdivision::refined_triangles() const {
    const auto corners = topology_.corners(topology_.levels());
    std::vector<Triangle> triangles(corners.size() / 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        triangles[t] = {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
    return triangles;
}

std::vector<double> FieldSubdivision::refined(std::span<const double> control) const {
    return topology_.refined(control);
}

std::vector<double> FieldSubdivision::limit(std::span<const double> control) const {
    return topology_.limit(topology_.refined(control));
}

SparseRows FieldSubdivision::stencils() const {
    return topology_.refined_rows();
}

SparseRows FieldSubdivision::limit_stencils(std::span<const std::uint32_t> control_vertices) const {
    return topology_.limit_rows(control_vertices);
}

}  // namespace stratareeb
