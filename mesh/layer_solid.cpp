// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "boreholes/errors.h"
#include "mesh/layer_model.h"
#include "mesh/soup_topology.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Face = TriMesh::FaceHandle;

bool is_closed_manifold(const TriangleSoup& soup) {
    if (std::ranges::any_of(soup.triangles, names_a_vertex_twice)) return false;
    const SoupTopology topology = soup_topology(soup);
    for (std::size_t e = 0; e < topology.edge_count(); ++e)
        if (topology.sides_of(e).size() != 2) return false;
    return corners_in_further_fans(soup, topology).empty();
}

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
        make_triangles();
        return std::move(solid_);
    }

    //! Would the solid touch itself, or not be a 2-manifold? Asked of corners at faults, where it could.
    bool touches_itself() {
        only_listed_ = true;
        make_triangles();
        TriangleSoup soup{.points = std::vector<Point3>(solid_.n_vertices()), .triangles = {}};
        std::map<std::array<double, 3>, std::uint32_t> at;
        std::vector<std::uint32_t> number;
        for (const Vertex v : solid_.vertices()) {
            const auto& p = solid_.point(v);
            const auto i = static_cast<std::uint32_t>(v.idx());
            number.push_back(at.try_emplace({p[0], p[1], p[2]}, i).first->second);
        }
        for (const auto& t : listed_) soup.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
        return !is_closed_manifold(soup);
    }

 private:
    void make_triangles() {
        std::size_t faces = 0;
        for (const auto f : plan_.faces()) faces += is_present(f);
        solid_.reserve(faces + 2, 3 * faces, 2 * faces);
        join_across_faults();
        for (const auto f : plan_.faces())
            if (is_present(f)) add_vertices(f);
        for (const auto f : plan_.faces())
            if (is_present(f)) add_top_and_base(f);
        for (const auto h : plan_.halfedges())
            if (!plan_.is_boundary(h) && plan_.is_boundary(plan_.opposite_halfedge_handle(h)) &&
                is_present(plan_.face_handle(h)))
                add_wall(plan_.from_vertex_handle(h), plan_.to_vertex_handle(h));
    }

    bool is_present(Face f) const {
        const auto i = static_cast<std::size_t>(f.idx());
        return model_.regions.in_face[i][layer_] && (!block_ || model_.seams.block[i] == *block_);
    }

    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.idx()); }

    void add_vertices(Face f) {
        for (const Vertex v : plan_.fv_range(f)) {
            const std::size_t i = index(v);
            if (top_[i].is_valid()) continue;
            top_[i] = vertex_at(i, level(layer_, i));
            base_[i] = model_.regions.zero_at[i][layer_] ? top_[i] : vertex_at(i, level(layer_ + 1, i));
        }
    }

    //! A new vertex, or the one that stands for both sides of a fault there.
    Vertex vertex_at(std::size_t v, double z) {
        const auto& p = plan_.point(Vertex(static_cast<int>(v)));
        if (!one_.contains({v, z})) return solid_.add_vertex({p[0], p[1], z});
        auto [it, fresh] = of_both_.try_emplace(root({v, z}));
        if (fresh) it->second = solid_.add_vertex({p[0], p[1], z});
        return it->second;
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

    //! Where a wall over a plan vertex has vertices from one level to another, both included.
    std::vector<double> wall_levels(std::size_t v, double low, double high) const {
        std::vector<double> levels{low};
        if (!model_.seams.empty())
            for (const double z : model_.seams.levels[v])
                if (z > low && z < high) levels.push_back(z);
        if (high > low) levels.push_back(high);
        return levels;
    }

    std::vector<Vertex> wall_vertices(std::size_t v, double low, double high) {
        const double base = level(layer_ + 1, v), top = level(layer_, v);
        const auto vertex = [&](double z) {
            if (z == top) return top_[v];
            if (z == base) return base_[v];
            auto [it, fresh] = between_.try_emplace({v, z});
            if (fresh) it->second = vertex_at(v, z);
            return it->second;
        };
        std::vector<Vertex> vertices;
        for (const double z : wall_levels(v, low, high)) vertices.push_back(vertex(z));
        return vertices;
    }

    //! Elevations at the two ends of an edge on a fault.
    using Pair = std::pair<double, double>;
    using FaultEdge = std::pair<std::uint32_t, std::uint32_t>;

    static bool is_above(const Pair& a, const Pair& b) { return a.first >= b.first && a.second >= b.second; }

    Pair levels_at(std::size_t horizon, std::size_t u, std::size_t w) const {
        return {level(horizon, u), level(horizon, w)};
    }

    const std::array<std::uint32_t, 2>* across(const FaultEdge& edge) const {
        const auto other = model_.seams.across.find(edge);
        return other == model_.seams.across.end() ? nullptr : &other->second;
    }

    //! Where the wall over an edge is cut, bottom up.
    std::vector<Pair> wall_cuts(const FaultEdge& edge) const {
        const auto [u, w] = edge;
        const Pair base = levels_at(layer_ + 1, u, w), top = levels_at(layer_, u, w);
        std::vector<Pair> cuts{base, top};
        if (const auto* other = across(edge))
            for (std::size_t k = 0; k < model_.horizons.size(); ++k) {
                const Pair cut = levels_at(k, (*other)[0], (*other)[1]);
                if (is_above(cut, base) && is_above(top, cut)) cuts.push_back(cut);
            }
        std::ranges::sort(cuts);
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        return cuts;
    }

    //! Has the same body the layer on the other side too, beside this part of a wall?
    bool is_within(const FaultEdge& edge, const Pair& low, const Pair& high) const {
        const auto* other = across(edge);
        if (!other) return false;
        const auto [v, x] = *other;
        const Face here = face_left_of(edge.first, edge.second), there = face_left_of(x, v);
        return is_present(there) && piece(here) == piece(there) &&
               is_above(low, levels_at(layer_ + 1, v, x)) && is_above(levels_at(layer_, v, x), high);
    }

    Face face_left_of(std::uint32_t u, std::uint32_t w) const {
        return plan_.face_handle(
            plan_.find_halfedge(Vertex(static_cast<int>(u)), Vertex(static_cast<int>(w))));
    }

    std::uint32_t piece(Face f) const { return model_.seams.block[static_cast<std::size_t>(f.idx())]; }

    //! Beside a fault that dies out one body may have the layer on both sides: no wall is there, and its vertices are one.
    void join_across_faults() {
        for (const auto& [edge, other] : model_.seams.across) {
            if (!is_present(face_left_of(edge.first, edge.second))) continue;
            const std::vector<Pair> cuts = wall_cuts(edge);
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                if (!is_within(edge, cuts[i], cuts[i + 1])) continue;
                for (const double z : wall_levels(edge.first, cuts[i].first, cuts[i + 1].first))
                    join({edge.first, z}, {other[0], z});
                for (const double z : wall_levels(edge.second, cuts[i].second, cuts[i + 1].second))
                    join({edge.second, z}, {other[1], z});
            }
        }
    }

    using PlanLevel = std::pair<std::size_t, double>;  // a plan vertex and an elevation there

    PlanLevel root(PlanLevel v) const {
        while (one_.at(v) != v) v = one_.at(v);
        return v;
    }

    void join(const PlanLevel& a, const PlanLevel& b) {
        one_.try_emplace(a, a);
        one_.try_emplace(b, b);
        const auto [low, high] = std::minmax({root(a), root(b)});
        one_[high] = low;
    }

    //! A wall is cut along the horizons of the other side, so that both sides have the same triangles.
    void add_fault_wall(Vertex from, Vertex to) {
        const FaultEdge edge{static_cast<std::uint32_t>(from.idx()), static_cast<std::uint32_t>(to.idx())};
        const std::vector<Pair> cuts = wall_cuts(edge);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (!is_within(edge, cuts[i], cuts[i + 1]))
                add_strip(wall_vertices(index(from), cuts[i].first, cuts[i + 1].first),
                          wall_vertices(index(to), cuts[i].second, cuts[i + 1].second));
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
        if (only_listed_) {
            listed_.push_back({static_cast<std::uint32_t>(a.idx()), static_cast<std::uint32_t>(b.idx()),
                               static_cast<std::uint32_t>(c.idx())});
            return;
        }
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
    std::map<PlanLevel, Vertex> between_;
    std::map<PlanLevel, PlanLevel> one_;  // towards the one that stands for both sides of a fault
    std::map<PlanLevel, Vertex> of_both_;
    TriMesh solid_;
    bool only_listed_ = false;  // triangles go to the list instead of the mesh
    std::vector<std::array<std::uint32_t, 3>> listed_;
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

bool touches_itself(const LayerModel& model, std::size_t layer, std::uint32_t block) {
    return SolidBuilder(model, layer, block).touches_itself();
}

std::vector<LayerSolid> build_block_solids(const LayerModel& model, std::size_t layer, NormalWeight weight) {
    if (model.seams.empty()) return {build_layer_solid(model, layer, weight)};
    std::vector<LayerSolid> solids;
    for (std::uint32_t block = 0; block < model.seams.blocks; ++block) {
        LayerSolid solid{.order = layer + 1,
                         .block = model.seams.blocks == 1 ? 0 : block + 1,
                         .unit = model.units[layer],
                         .surface = SolidBuilder(model, layer, block).build()};
        if (solid.surface.n_faces() == 0) continue;
        update_vertex_normals(solid.surface, weight);
        solids.push_back(std::move(solid));
    }
    return solids;
}

}  // namespace stratareeb
