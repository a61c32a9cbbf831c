// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

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
    //! Of one block of a faulted model, or of all.
    SolidBuilder(const LayerModel& model, std::size_t layer, std::optional<std::uint32_t> block)
        : model_(model),
          plan_(model.plan.surface),
          layer_(layer),
          block_(block),
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
        const auto i = static_cast<std::size_t>(f.idx());
        return model_.regions.in_face[i][layer_] && (!block_ || model_.seams.block[i] == *block_);
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
        if (is_at_fault(from) || is_at_fault(to)) return add_fault_wall(from, to);
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

    bool is_at_fault(Vertex v) const {
        return !model_.seams.empty() && !model_.seams.levels[index(v)].empty();
    }

    double level(std::size_t horizon, std::size_t v) const { return model_.horizons[horizon][v]; }

    //! Vertices of the wall over a plan vertex from one level to another, both included.
    std::vector<Vertex> wall_vertices(Vertex plan, double low, double high) {
        const std::size_t v = index(plan);
        const double base = level(layer_ + 1, v), top = level(layer_, v);
        const auto vertex = [&](double z) {
            if (z == top) return top_[v];
            if (z == base) return base_[v];
            auto [it, fresh] = between_.try_emplace({v, z});
            if (fresh) it->second = solid_.add_vertex({plan_.point(plan)[0], plan_.point(plan)[1], z});
            return it->second;
        };
        std::vector<Vertex> vertices{vertex(low)};
        if (is_at_fault(plan))
            for (const double z : model_.seams.levels[v])
                if (z > low && z < high) vertices.push_back(vertex(z));
        if (high > low) vertices.push_back(vertex(high));
        return vertices;
    }

    //! A wall is cut along the horizons of the other side, so that both sides have the same triangles.
    void add_fault_wall(Vertex from, Vertex to) {
        const std::size_t u = index(from), w = index(to);
        using Pair = std::pair<double, double>;
        const Pair base{level(layer_ + 1, u), level(layer_ + 1, w)}, top{level(layer_, u), level(layer_, w)};
        std::vector<Pair> cuts{base, top};
        const auto other =
            model_.seams.across.find({static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(w)});
        if (other != model_.seams.across.end())
            for (std::size_t k = 0; k < model_.horizons.size(); ++k) {
                const Pair cut{level(k, other->second[0]), level(k, other->second[1])};
                if (cut.first >= base.first && cut.second >= base.second && cut.first <= top.first &&
                    cut.second <= top.second)
                    cuts.push_back(cut);
            }
        std::ranges::sort(cuts);
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            add_strip(wall_vertices(from, cuts[i].first, cuts[i + 1].first),
                      wall_vertices(to, cuts[i].second, cuts[i + 1].second));
    }

    //! Triangles between two chains of vertices, from the bottom up; the shorter diagonal first. Seen from the other side
    //! the chains change places and the triangles are the same.
    void add_strip(const std::vector<Vertex>& left, const std::vector<Vertex>& right) {
        const auto squared = [&](Vertex a, Vertex b) {
            return (solid_.point(a) - solid_.point(b)).sqrnorm();
        };
        const auto &p = solid_.point(left[0]), &q = solid_.point(right[0]);
        const bool left_first = std::pair(p[0], p[1]) < std::pair(q[0], q[1]);
        for (std::size_t i = 0, j = 0; i + 1 < left.size() || j + 1 < right.size();) {
            bool up_left = j + 1 >= right.size();
            if (!up_left && i + 1 < left.size()) {
                const double a = squared(left[i + 1], right[j]), b = squared(left[i], right[j + 1]);
                up_left = a < b || (a == b && left_first);
            }
            if (up_left) {
                add_face(left[i], right[j], left[i + 1]);
                ++i;
            } else {
                add_face(left[i], right[j], right[j + 1]);
                ++j;
            }
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
    std::optional<std::uint32_t> block_;
    std::vector<Vertex> top_, base_;
    std::map<std::pair<std::size_t, double>, Vertex> between_;  // plan vertex, elevation
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
        .order = layer + 1, .unit = model.units[layer], .surface = SolidBuilder(model, layer, {}).build()};
    update_vertex_normals(solid.surface, weight);
    return solid;
}

std::vector<LayerSolid> build_block_solids(const LayerModel& model, std::size_t layer, NormalWeight weight) {
    if (model.seams.empty()) return {build_layer_solid(model, layer, weight)};
    std::vector<LayerSolid> solids;
    for (std::uint32_t block = 0; block < model.seams.blocks; ++block) {
        LayerSolid solid{.order = layer + 1,
                         .block = block + 1,
                         .unit = model.units[layer],
                         .surface = SolidBuilder(model, layer, block).build()};
        if (solid.surface.n_faces() == 0) continue;
        update_vertex_normals(solid.surface, weight);
        solids.push_back(std::move(solid));
    }
    return solids;
}

}  // namespace stratareeb
