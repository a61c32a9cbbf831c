// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/fairness_rows.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;
using Term = std::pair<std::uint32_t, double>;

constexpr double kStraight = 1e-6;  // radians
constexpr double kFlattest =
    1e-3;  // twice a triangle's area over its squared sides: cotangents stay below 1/that

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

//! Add sum of w (value of neighbour - value of v), w scaled to magnitude 1 in all.
void add_row(FairnessRows& rows, Vertex v, std::vector<Term>& terms) {
    double all = 0, sum = 0;
    for (const Term& term : terms) all += std::abs(term.second), sum += term.second;
    if (!(all > 0)) return;
    terms.emplace_back(static_cast<std::uint32_t>(v.idx()), -sum);
    std::ranges::sort(terms);
    for (const auto& [u, w] : terms) {
        rows.rows.column.push_back(u);
        rows.rows.weight.push_back(w / all);
    }
    rows.rows.first.push_back(static_cast<std::uint32_t>(rows.rows.column.size()));
    rows.vertex.push_back(index(v));
}

class Bending {
 public:
    Bending(const TriMesh& mesh, const std::vector<double>& x, const std::vector<double>& y)
        : mesh_(mesh), x_(x), y_(y) {}

    FairnessRows run() {
        for (const Vertex v : mesh_.vertices())
            if (mesh_.is_boundary(v))
                along_rim(v);
            else
                across(v);
        return std::move(rows_);
    }

 private:
    std::array<double, 2> vector(Vertex a, Vertex b) const {
        return {x_[index(b)] - x_[index(a)], y_[index(b)] - y_[index(a)]};
    }

    double cotangent(Vertex apex, Vertex a, Vertex b) const {
        const auto u = vector(apex, a), w = vector(apex, b);
        const double twice_area = u[0] * w[1] - u[1] * w[0], dot = u[0] * w[0] + u[1] * w[1];
        const double squares = u[0] * u[0] + u[1] * u[1] + w[0] * w[0] + w[1] * w[1];
        if (std::abs(twice_area) < kFlattest * squares) flat_ = true;
        return dot / twice_area;
    }

    void across(Vertex v) {
        std::vector<Term> terms;
        flat_ = false;
        for (const Halfedge h : mesh_.voh_range(v)) {
            const Halfedge o = mesh_.opposite_halfedge_handle(h);
            const Vertex u = mesh_.to_vertex_handle(h);
            const Vertex left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)),
                         right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(o));
            terms.emplace_back(u.idx(), cotangent(left, v, u) + cotangent(right, u, v));
        }
        if (!flat_) add_row(rows_, v, terms);
    }

    void along_rim(Vertex v) {
        const Halfedge out = mesh_.halfedge_handle(v), in = mesh_.prev_halfedge_handle(out);
        const Vertex a = mesh_.from_vertex_handle(in), b = mesh_.to_vertex_handle(out);
        const auto u = vector(v, a), w = vector(v, b);
        const double turn = std::atan2(u[0] * w[1] - u[1] * w[0], -(u[0] * w[0] + u[1] * w[1]));
        if (std::abs(turn) > kStraight) return;
        std::vector<Term> terms{{static_cast<std::uint32_t>(a.idx()), 1 / std::hypot(u[0], u[1])},
                                {static_cast<std::uint32_t>(b.idx()), 1 / std::hypot(w[0], w[1])}};
        add_row(rows_, v, terms);
    }

    const TriMesh& mesh_;
    const std::vector<double>&x_, &y_;
    mutable bool flat_ = false;
    FairnessRows rows_;
};

}  // namespace

FairnessRows umbrella_rows(const TriMesh& mesh) {
    FairnessRows rows;
    for (const Vertex v : mesh.vertices()) {
        if (mesh.is_boundary(v)) continue;
        std::vector<Term> terms;
        for (const Vertex u : mesh.vv_range(v)) terms.emplace_back(u.idx(), 1.0);
        add_row(rows, v, terms);
    }
    return rows;
}

FairnessRows bending_rows(const TriMesh& mesh, const std::vector<double>& x, const std::vector<double>& y) {
    return Bending(mesh, x, y).run();
}

}  // namespace stratareeb
