// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/leaning_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {
namespace {

using Vertex = TriMesh::VertexHandle;
using Edge = TriMesh::EdgeHandle;
using Halfedge = TriMesh::HalfedgeHandle;

constexpr double kSlopesFall = 0.75;  // from level to level
constexpr double kLoopFar = 0.375;

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

std::uint32_t number(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
}

//! How much the plan around a vertex shrinks from level to level: the second eigenvalue of Loop's rule.
double plan_shrinks(std::size_t valence) {
    return 0.375 + 0.25 * std::cos(2 * std::numbers::pi / static_cast<double>(valence));
}

//! In a fan between two lines of no thickness, values shrink by far + cos(pi / triangles) / 4.
double far_weight(std::size_t triangles, std::size_t valence) {
    const double far = kSlopesFall * plan_shrinks(valence) -
                       0.25 * std::cos(std::numbers::pi / static_cast<double>(triangles));
    return std::clamp(far, 0.0, kLoopFar);
}

std::vector<char> ends_of(const TriMesh& mesh, const FieldCreases& creases) {
    std::vector<char> flags(mesh.n_vertices(), 0);
    for (const std::uint32_t e : creases.edges) {
        const Halfedge h = mesh.halfedge_handle(Edge(static_cast<int>(e)), 0);
        for (const Vertex v : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)}) flags[index(v)] = 1;
    }
    for (const std::uint32_t v : creases.corners) flags[v] = 1;
    return flags;
}

//! The next half-edge from the same vertex, counter-clockwise.
Halfedge turned(const TriMesh& mesh, Halfedge h) {
    return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

}  // namespace

std::vector<LeaningEdge> leaning_edges(const LayerModel& model, std::size_t layer, const FieldCreases& plan) {
    const TriMesh& mesh = model.plan.surface;
    const std::vector<char> is_plan_crease = ends_of(mesh, plan);
    const auto has_layer = [&](Halfedge h) -> bool {
        return model.regions.in_face[index(mesh.face_handle(h))][layer];
    };
    std::vector<LeaningEdge> result;
    for (const Vertex v : mesh.vertices()) {
        if (!model.regions.zero_at[index(v)][layer] || mesh.is_boundary(v) || is_plan_crease[index(v)])
            continue;
        for (const Halfedge first : mesh.voh_range(v)) {
            if (!has_layer(first) || has_layer(mesh.opposite_halfedge_handle(first))) continue;
            std::vector<Halfedge> inner;  // edges of the fan that begins there
            for (Halfedge h = turned(mesh, first); has_layer(h); h = turned(mesh, h)) inner.push_back(h);
            const std::size_t triangles = inner.size() + 1, valence = mesh.valence(v);
            const double far = far_weight(triangles, valence);
            if (2 * triangles == valence || far == kLoopFar) continue;
            for (const Halfedge h : inner) result.push_back({number(mesh.edge_handle(h)), number(v), far});
        }
    }
    return result;
}

}  // namespace stratareeb
