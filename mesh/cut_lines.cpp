// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut_lines.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Edge = TriMesh::EdgeHandle;
using Halfedge = TriMesh::HalfedgeHandle;
using Face = TriMesh::FaceHandle;

constexpr double kMoves = 0.2;  // of an edge's length: vertices closer to the line than that are moved to it
constexpr double kKeepsArea = 0.25;  // of a triangle's area, at least, when one of its corners moves

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

std::uint32_t number(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
}

double doubled_area(const TriMesh::Point& a, const TriMesh::Point& b, const TriMesh::Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

class LineInsertion {
 public:
    LineInsertion(TriMesh& mesh, std::vector<LayerSet>& in_face, const LevelLine& line)
        : mesh_(mesh), in_face_(in_face), line_(line), value_(line.value.begin(), line.value.end()) {}

    std::vector<std::uint32_t> run() {
        for (const Vertex v : mesh_.vertices())
            if (!line_.fixed[index(v)] && value_[index(v)] != 0) move_to_line(v);
        const std::size_t edges = mesh_.n_edges();
        for (std::size_t e = 0; e < edges; ++e) cut(Edge(static_cast<int>(e)));
        return std::move(on_line_);
    }

 private:
    bool is_active(Edge e) const {
        for (const int side : {0, 1})
            if (const Halfedge h = mesh_.halfedge_handle(e, side);
                !mesh_.is_boundary(h) && in_face_[index(mesh_.face_handle(h))][line_.layer])
                return true;
        return false;
    }

    //! Where along the edge from a to b the value is 0; nowhere, negative.
    double crossing(Vertex a, Vertex b) const {
        const double from = value_[index(a)], to = value_[index(b)];
        return (from < 0 && to > 0) || (from > 0 && to < 0) ? from / (from - to) : -1;
    }

    void move_to_line(Vertex v) {
        double closest = kMoves;
        Vertex towards;
        for (const Halfedge h : mesh_.voh_range(v)) {
            if (!is_active(mesh_.edge_handle(h))) continue;
            const double share = crossing(v, mesh_.to_vertex_handle(h));
            if (share > 0 && share < closest) closest = share, towards = mesh_.to_vertex_handle(h);
        }
        if (!towards.is_valid()) return;
        const TriMesh::Point to = mesh_.point(v) + closest * (mesh_.point(towards) - mesh_.point(v));
        for (const Halfedge h : mesh_.voh_range(v)) {
            const TriMesh::Point &b = mesh_.point(mesh_.to_vertex_handle(h)),
                                 &c = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)));
            if (!(doubled_area(to, b, c) >= kKeepsArea * doubled_area(mesh_.point(v), b, c))) return;
        }
        mesh_.set_point(v, to);
        value_[index(v)] = 0;
        on_line_.push_back(number(v));
        line_.on_vertex({number(v), {{number(v), 1 - closest}, {number(towards), closest}}});
    }

    void cut(Edge e) {
        if (!is_active(e)) return;
        const Halfedge h = mesh_.halfedge_handle(e, 0);
        const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
        const double share = crossing(a, b);
        if (share < 0) return;
        const LayerSet left = mesh_.is_boundary(h) ? LayerSet() : in_face_[index(mesh_.face_handle(h))];
        const Halfedge o = mesh_.opposite_halfedge_handle(h);
        const LayerSet right = mesh_.is_boundary(o) ? LayerSet() : in_face_[index(mesh_.face_handle(o))];
        const Vertex apex =
            mesh_.is_boundary(h) ? Vertex() : mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
        const Vertex v = mesh_.add_vertex(mesh_.point(a) + share * (mesh_.point(b) - mesh_.point(a)));
        mesh_.split(e, v);
        for (std::size_t f = in_face_.size(); f < mesh_.n_faces(); ++f) {
            bool on_left = false;
            for (const Vertex corner : mesh_.fv_range(Face(static_cast<int>(f)))) on_left |= corner == apex;
            in_face_.push_back(on_left ? left : right);
        }
        value_.push_back(0);
        on_line_.push_back(number(v));
        line_.on_vertex({number(v), {{number(a), 1 - share}, {number(b), share}}});
    }

    TriMesh& mesh_;
    std::vector<LayerSet>& in_face_;
    const LevelLine& line_;
    std::vector<double> value_;
    std::vector<std::uint32_t> on_line_;
};

}  // namespace

std::vector<std::uint32_t> insert_level_line(TriMesh& mesh, std::vector<LayerSet>& in_face,
                                             const LevelLine& line) {
    return LineInsertion(mesh, in_face, line).run();
}

}  // namespace stratareeb
