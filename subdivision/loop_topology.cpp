// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/loop_topology.h"

#include <algorithm>

namespace stratareeb {

namespace {

using Corner = std::array<std::uint32_t, 3>;

std::uint32_t number(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
}

void count_valence(LoopLevel& level) {
    level.valence.assign(level.vertices, 0);
    for (const auto& [a, b] : level.ends) ++level.valence[a], ++level.valence[b];
}

//! A level and, for its triangles, the edges facing their corners.
struct Growing {
    LoopLevel level;
    std::vector<Corner> edges;  // [triangle][k]: the edge that joins corners k + 1 and k + 2
};

Growing control_level(const TriMesh& mesh) {
    Growing control;
    LoopLevel& level = control.level;
    level.vertices = mesh.n_vertices();
    for (const auto e : mesh.edges()) {
        auto h = mesh.halfedge_handle(e, 0);
        if (mesh.is_boundary(h)) h = mesh.opposite_halfedge_handle(h);
        const auto o = mesh.opposite_halfedge_handle(h);
        level.ends.push_back({number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h))});
        const auto apex = [&](auto side) {
            return mesh.is_boundary(side) ? LoopLevel::kNone
                                          : number(mesh.to_vertex_handle(mesh.next_halfedge_handle(side)));
        };
        level.across.push_back({apex(h), apex(o)});
    }
    for (const auto f : mesh.faces()) {
        Corner corner{}, edge{};
        auto h = mesh.halfedge_handle(f);
        for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
            corner[k] = number(mesh.from_vertex_handle(h));
            edge[(k + 2) % 3] = number(mesh.edge_handle(h));
        }
        level.triangles.push_back(corner);
        control.edges.push_back(edge);
    }
    count_valence(level);
    return control;
}

class Refinement {
 public:
    explicit Refinement(const Growing& coarse)
        : coarse_(coarse.level),
          coarse_edges_(coarse.edges),
          n_(static_cast<std::uint32_t>(coarse_.vertices)),
          m_(static_cast<std::uint32_t>(coarse_.ends.size())) {}

    Growing run() {
        LoopLevel& level = fine_.level;
        const std::size_t faces = coarse_.triangles.size();
        level.vertices = n_ + m_;
        level.triangles.resize(4 * faces);
        fine_.edges.resize(4 * faces);
        level.ends.resize(2 * m_ + 3 * faces);
        level.across.assign(level.ends.size(), {LoopLevel::kNone, LoopLevel::kNone});
        for (std::uint32_t e = 0; e < m_; ++e) {
            level.ends[2 * e] = {coarse_.ends[e][0], n_ + e};
            level.ends[2 * e + 1] = {n_ + e, coarse_.ends[e][1]};
        }
        for (std::uint32_t f = 0; f < faces; ++f) split(f);
        count_valence(level);
        return std::move(fine_);
    }

 private:
    //! The half of an edge at one of its ends.
    std::uint32_t half(std::uint32_t edge, std::uint32_t end) const {
        return 2 * edge + (coarse_.ends[edge][0] == end ? 0 : 1);
    }

    void split(std::uint32_t f) {
        const Corner &v = coarse_.triangles[f], &e = coarse_edges_[f];
        const Corner middle{n_ + e[0], n_ + e[1], n_ + e[2]};
        const std::uint32_t inner = 2 * m_ + 3 * f;  // inner edge k parts corner k from the centre
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t i = (k + 1) % 3, j = (k + 2) % 3;
            fine_.level.ends[inner + k] = {middle[j], middle[i]};
            set(4 * f + k, {v[k], middle[j], middle[i]}, {inner + k, half(e[i], v[k]), half(e[j], v[k])});
        }
        set(4 * f + 3, middle, {inner, inner + 1, inner + 2});
    }

    void set(std::uint32_t f, const Corner& corner, const Corner& edge) {
        fine_.level.triangles[f] = corner;
        fine_.edges[f] = edge;
        for (int k = 0; k < 3; ++k) {
            auto& across = fine_.level.across[edge[k]];
            across[across[0] == LoopLevel::kNone ? 0 : 1] = corner[k];
        }
    }

    const LoopLevel& coarse_;
    const std::vector<Corner>& coarse_edges_;
    std::uint32_t n_, m_;
    Growing fine_;
};

}  // namespace

LoopTopology::LoopTopology(const TriMesh& mesh, int levels) {
    Growing current = control_level(mesh);
    for (int k = 0; k < levels; ++k) {
        Growing next = Refinement(current).run();
        levels_.push_back(std::move(current.level));
        current = std::move(next);
    }
    levels_.push_back(std::move(current.level));
}

}  // namespace stratareeb
