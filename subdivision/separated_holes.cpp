// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/separated_holes.h"

#include <cstddef>

namespace stratareeb {

namespace {

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

class Separation {
 public:
    explicit Separation(LayerModel& model)
        : model_(model), mesh_(model.plan.surface), is_hole_(mesh_.n_vertices(), 0) {
        for (const auto v : model.plan.hole_vertex)
            if (v != PlanMesh::kNoVertex) is_hole_[v] = 1;
    }

    void run() {
        const std::size_t edges = mesh_.n_edges();
        for (std::size_t e = 0; e < edges; ++e) {
            const TriMesh::EdgeHandle edge(static_cast<int>(e));
            const auto h = mesh_.halfedge_handle(edge, 0);
            const auto a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
            if (is_hole_[index(a)] && is_hole_[index(b)]) split(edge, index(a), index(b));
        }
    }

 private:
    void split(TriMesh::EdgeHandle edge, std::size_t a, std::size_t b) {
        LayerSet layers[2];
        TriMesh::VertexHandle apex[2];
        for (const int side : {0, 1}) {
            const auto h = mesh_.halfedge_handle(edge, static_cast<unsigned>(side));
            if (mesh_.is_boundary(h)) continue;
            layers[side] = model_.regions.in_face[index(mesh_.face_handle(h))];
            apex[side] = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
        }
        const bool is_rim = mesh_.is_boundary(edge);
        const auto middle = mesh_.add_vertex(mesh_.calc_edge_midpoint(edge));
        mesh_.split(edge, middle);
        while (model_.regions.in_face.size() < mesh_.n_faces()) {
            const TriMesh::FaceHandle f(static_cast<int>(model_.regions.in_face.size()));
            bool first = false;
            for (const auto v : mesh_.fv_range(f)) first |= v == apex[0];
            model_.regions.in_face.push_back(layers[first ? 0 : 1]);
        }
        add_values(a, b, is_rim, middle);
        is_hole_.push_back(0);
    }

    void add_values(std::size_t a, std::size_t b, bool is_rim, TriMesh::VertexHandle middle) {
        auto& regions = model_.regions;
        LayerSet zero = is_rim ? regions.zero_at[a] & regions.zero_at[b] : LayerSet();
        for (const auto f : mesh_.vf_range(middle)) zero |= ~regions.in_face[index(f)];
        for (std::size_t i = model_.units.size(); i < kMaxLayers; ++i) zero.reset(i);
        regions.zero_at.push_back(zero);
        auto& horizons = model_.horizons;
        std::vector<double> thickness;
        for (std::size_t i = 0; i < model_.units.size(); ++i)
            thickness.push_back(zero[i] ? 0 : 0.5 * (model_.thickness(i, a) + model_.thickness(i, b)));
        horizons[0].push_back(0.5 * (horizons[0][a] + horizons[0][b]));
        for (std::size_t i = 0; i < model_.units.size(); ++i)
            horizons[i + 1].push_back(horizons[i].back() - thickness[i]);
    }

    LayerModel& model_;
    TriMesh& mesh_;
    std::vector<char> is_hole_;
};

}  // namespace

LayerModel separated_holes(LayerModel model) {
    Separation(model).run();
    return model;
}

}  // namespace stratareeb
