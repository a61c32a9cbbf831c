// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_solid.h"

#include <fmt/format.h>

#include <array>

#include "boreholes/errors.h"
#include "mesh/layer_model.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Face = TriMesh::FaceHandle;

//! Top and base vertices of one layer's solid over the plan vertices; the same vertex where the layer has no
//! thickness.
class SolidBuilder {
 public:
    SolidBuilder(const LayerModel& model, std::size_t layer)
        : model_(model),
          plan_(model.plan.surface),
          layer_(layer),
          top_(plan_.n_vertices()),
          base_(plan_.n_vertices()) {}

    TriMesh build() {
        std::size_t faces = 0;
        for (const auto f : plan_.faces()) faces += is_present(f);
        solid_.reserve(faces + 2, 3 * faces, 2 * faces);
        for (const auto f : plan_.faces())
            if (is_present(f)) add_vertices(f);
        for (const auto f : plan_.faces())
            if (is_present(f)) add_top_and_base(f);
        for (const auto h : plan_.halfedges())
            if (!plan_.is_boundary(h) && plan_.is_boundary(plan_.opposite_halfedge_handle(h)) &&
                is_present(plan_.face_handle(h)))
                add_wall(plan_.from_vertex_handle(h), plan_.to_vertex_handle(h));
        return std::move(solid_);
    }

 private:
    bool is_present(Face f) const {
        return model_.regions.in_face[static_cast<std::size_t>(f.idx())][layer_];
    }

    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.idx()); }

    void add_vertices(Face f) {
        for (const Vertex v : plan_.fv_range(f)) {
            const std::size_t i = index(v);
            if (top_[i].is_valid()) continue;
            const auto& p = plan_.point(v);
            top_[i] = solid_.add_vertex({p[0], p[1], model_.horizons[layer_][i]});
            base_[i] = model_.regions.zero_at[i][layer_]
                           ? top_[i]
                           : solid_.add_vertex({p[0], p[1], model_.horizons[layer_ + 1][i]});
        }
    }

    void add_top_and_base(Face f) {
        auto corner = plan_.cfv_ccwbegin(f);
        const std::size_t a = index(*corner), b = index(*++corner), c = index(*++corner);
        add_face(top_[a], top_[b], top_[c]);
        add_face(base_[a], base_[c], base_[b]);
    }

    // The plan's inside lies left of a -> b, so from outside a is on the left. The wall is cut along its
    // shorter diagonal.
    void add_wall(Vertex from, Vertex to) {
        const Vertex a = top_[index(from)], b = top_[index(to)], a0 = base_[index(from)],
                     b0 = base_[index(to)];
        if (a == a0 && b == b0) return;
        if (a == a0) return add_face(a, b0, b);
        if (b == b0) return add_face(a0, b, a);
        const auto length = [&](Vertex u, Vertex v) { return (solid_.point(u) - solid_.point(v)).sqrnorm(); };
        if (length(a0, b) <= length(a, b0)) {
            add_face(a0, b0, b);
            add_face(a0, b, a);
        } else {
            add_face(a0, b0, a);
            add_face(a, b0, b);
        }
    }

    void add_face(Vertex a, Vertex b, Vertex c) {
        if (solid_.add_face(a, b, c).is_valid()) return;
        const auto& p = solid_.point(a);
        throw GeometryError(
            fmt::format("the solid of layer '{}' is not a 2-manifold near x {:.10g}, y {:.10g}, z {:.10g}",
                        model_.units[layer_].code, p[0] + model_.origin.x, p[1] + model_.origin.y,
                        p[2] + model_.origin.z));
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    std::size_t layer_;
    std::vector<Vertex> top_, base_;
    TriMesh solid_;
};

}  // namespace

TriMesh horizon_surface(const LayerModel& model, std::size_t k, NormalWeight weight) {
    TriMesh surface = model.plan.surface;
    for (const auto v : surface.vertices()) {
        auto& p = surface.point(v);
        p[2] = model.horizons[k][static_cast<std::size_t>(v.idx())];
    }
    update_vertex_normals(surface, weight);
    return surface;
}

LayerSolid build_layer_solid(const LayerModel& model, std::size_t layer, NormalWeight weight) {
    LayerSolid solid{
        .order = layer + 1, .unit = model.units[layer], .surface = SolidBuilder(model, layer).build()};
    update_vertex_normals(solid.surface, weight);
    return solid;
}

}  // namespace stratareeb
