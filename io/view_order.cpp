// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/view_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "boreholes/errors.h"
#include "boreholes/hole_triangulation.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ~0u;

std::array<std::uint32_t, 3> corners(const TriMesh& plan, TriMesh::FaceHandle face) {
    std::array<std::uint32_t, 3> result{};
    std::size_t k = 0;
    for (const auto v : plan.fv_range(face)) result[k++] = static_cast<std::uint32_t>(v.idx());
    return result;
}

//! Breadth first over common edges, piece by piece.
std::vector<std::uint32_t> neighbourly_faces(const TriMesh& plan) {
    std::vector<std::uint32_t> order;
    order.reserve(plan.n_faces());
    std::vector<char> seen(plan.n_faces());
    for (std::uint32_t start = 0; start < plan.n_faces(); ++start) {
        if (seen[start]) continue;
        seen[start] = 1;
        order.push_back(start);
        for (std::size_t next = order.size() - 1; next < order.size(); ++next)
            for (const auto f : plan.ff_range(TriMesh::FaceHandle(static_cast<int>(order[next])))) {
                const auto i = static_cast<std::uint32_t>(f.idx());
                if (!seen[i]) order.push_back(i);
                seen[i] = 1;
            }
    }
    return order;
}

template <class T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<std::uint32_t>& which) {
    std::vector<T> result;
    result.reserve(which.size());
    for (const std::uint32_t i : which) result.push_back(values[i]);
    return result;
}

void add_face(TriMesh& plan, const std::array<std::uint32_t, 3>& corner) {
    const auto vertex = [&](std::size_t k) { return TriMesh::VertexHandle(static_cast<int>(corner[k])); };
    if (!plan.add_face(vertex(0), vertex(1), vertex(2)).is_valid())
        throw GeometryError("the plan of the model is not a 2-manifold; build the model again");
}

//! A layer is in a triangle where a corner has thickness.
LayerRegions regions_by_thickness(const LayerModel& model) {
    LayerRegions regions;
    regions.zero_at.resize(model.plan.surface.n_vertices());
    regions.in_face.resize(model.plan.surface.n_faces());
    for (std::size_t i = 0; i < model.units.size(); ++i)
        for (std::size_t v = 0; v < regions.zero_at.size(); ++v)
            regions.zero_at[v][i] = model.thickness(i, v) == 0;
    for (const auto f : model.plan.surface.faces())
        for (const std::uint32_t v : corners(model.plan.surface, f))
            for (std::size_t i = 0; i < model.units.size(); ++i)
                if (!regions.zero_at[v][i]) regions.in_face[static_cast<std::size_t>(f.idx())].set(i);
    return regions;
}

LayerModel without_geometry(const LayerModel& model) {
    LayerModel result;
    result.units = model.units;
    result.origin = model.origin;
    result.length_unit = model.length_unit;
    result.columns = model.columns;
    result.spacing = model.spacing;
    return result;
}

}  // namespace

LayerModel in_view_order(const LayerModel& model) {
    const TriMesh& plan = model.plan.surface;
    const std::vector<std::uint32_t> faces = neighbourly_faces(plan);
    std::vector<std::uint32_t> vertices, new_vertex(plan.n_vertices(), kNone);
    LayerModel result = without_geometry(model);
    TriMesh& surface = result.plan.surface;
    surface.reserve(plan.n_vertices(), plan.n_edges(), plan.n_faces());
    for (const std::uint32_t f : faces) {
        auto corner = corners(plan, TriMesh::FaceHandle(static_cast<int>(f)));
        for (std::uint32_t& v : corner) {
            if (new_vertex[v] == kNone) {
                new_vertex[v] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(v);
                surface.add_vertex(plan.point(TriMesh::VertexHandle(static_cast<int>(v))));
            }
            v = new_vertex[v];
        }
        add_face(surface, corner);
    }
    for (const std::uint32_t v : model.plan.hole_vertex)
        result.plan.hole_vertex.push_back(v == PlanMesh::kNoVertex ? v : new_vertex[v]);
    result.regions.in_face = picked(model.regions.in_face, faces);
    result.regions.zero_at = picked(model.regions.zero_at, vertices);
    for (const auto& horizon : model.horizons) result.horizons.push_back(picked(horizon, vertices));
    return result;
}

LayerModel straight_between_holes(const LayerModel& model) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t v : model.plan.hole_vertex)
        if (v != PlanMesh::kNoVertex) vertices.push_back(v);
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    LayerModel result = without_geometry(model);
    if (vertices.size() < 3) return result;
    std::vector<Point2> sites;
    for (const std::uint32_t v : vertices) {
        const auto& p = model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
        sites.push_back({p[0], p[1]});
        result.plan.surface.add_vertex({p[0], p[1], 0});
    }
    const HoleTriangulation between(std::move(sites));
    for (const auto& triangle : between.triangles()) add_face(result.plan.surface, triangle);
    for (const auto& horizon : model.horizons) result.horizons.push_back(picked(horizon, vertices));
    result.regions = regions_by_thickness(result);
    return result;
}

}  // namespace stratareeb
