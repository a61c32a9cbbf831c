// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_regions.h"

#include <fmt/format.h>

#include <algorithm>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Edge = TriMesh::EdgeHandle;
using Halfedge = TriMesh::HalfedgeHandle;
using Face = TriMesh::FaceHandle;

constexpr double kOnLine = 1e-9;  // a share as close as that to the rule's fraction is on the pinch-out line
constexpr int kMaxRounds = 64;    // cut, open, cut again: two or three suffice
constexpr int kRingRounds = 6;    // from then on, layers are left out of whole triangles instead of rings

Point2 plan_point(const TriMesh& mesh, Vertex v) {
    return {mesh.point(v)[0], mesh.point(v)[1]};
}

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

std::uint32_t number(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
}

class Regions {
 public:
    Regions(PlanMesh& plan, const ThicknessField& field, double opening)
        : mesh_(plan.surface), field_(&field), opening_(opening) {
        for (std::size_t i = 0; i < field.layers(); ++i) all_.set(i);
    }

    //! Of known regions, without a field that says more.
    Regions(PlanMesh& plan, LayerRegions known, std::size_t layers, const LayerRegionsOptions& options)
        : mesh_(plan.surface),
          opening_(options.opening),
          on_vertex_(options.on_vertex),
          present_(std::move(known.in_face)),
          on_line_(std::move(known.zero_at)),
          opened_(known.opened) {
        for (std::size_t i = 0; i < layers; ++i) all_.set(i);
    }

    void label() {
        std::vector<Point2> centres, corners;
        for (const Face f : mesh_.faces()) {
            const auto c = mesh_.calc_face_centroid(f);
            centres.push_back({c[0], c[1]});
        }
        for (const PlanLocation& l : field_->holes().locate(centres)) present_.push_back(layers_present(l));
        for (const Vertex v : mesh_.vertices()) corners.push_back(plan_point(mesh_, v));
        for (const PlanLocation& l : field_->holes().locate(corners))
            on_line_.push_back(layers_on_line_or_beyond(l));
    }

    void make_manifold() {
        for (int round = 0; round < kMaxRounds; ++round) {
            cut_chords();
            if (!open_pinched_vertices(round < kRingRounds)) return cut_flat_faces();
        }
        throw GeometryError(
            "pinch-out lines lie too close to one another (give a smaller --spacing or another --pinch-out)");
    }

    LayerRegions take() {
        LayerRegions regions;
        regions.opened = opened_;
        for (const Vertex v : mesh_.vertices()) regions.zero_at.push_back(zero_at(v));
        regions.in_face = std::move(present_);
        return regions;
    }

 private:
    LayerSet layers_present(const PlanLocation& l) const {
        LayerSet set;
        for (std::size_t i = 0; i < field_->layers(); ++i) set[i] = field_->is_present(i, l);
        return set;
    }

    LayerSet layers_on_line_or_beyond(const PlanLocation& l) const {
        LayerSet set;
        for (std::size_t i = 0; i < field_->layers(); ++i)
            set[i] = field_->share(i, l) <= field_->rule().fraction + kOnLine;
        return set;
    }

    LayerSet layers_on_line_or_beyond(const Point2& at) const {
        return field_ ? layers_on_line_or_beyond(field_->holes().locate(std::span(&at, 1))[0]) : LayerSet();
    }

    LayerSet around(Vertex v) const {
        LayerSet everywhere = all_;
        for (const Face f : mesh_.vf_range(v)) everywhere &= present_[index(f)];
        return everywhere;
    }

    LayerSet zero_at(Vertex v) const { return on_line_[index(v)] | (all_ & ~around(v)); }

    LayerSet in_both_faces(Edge e) const {
        LayerSet set = all_;
        for (const int side : {0, 1})
            if (const Halfedge h = mesh_.halfedge_handle(e, side); !mesh_.is_boundary(h))
                set &= present_[index(mesh_.face_handle(h))];
        return set;
    }

    std::pair<Vertex, Vertex> ends(Edge e) const {
        const Halfedge h = mesh_.halfedge_handle(e, 0);
        return {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)};
    }

    Vertex add_vertex(const TriMesh::Point& p) {
        on_line_.push_back(layers_on_line_or_beyond(Point2{p[0], p[1]}));
        return mesh_.add_vertex(p);
    }

    void report(Vertex v, Vertex a, Vertex b) const {
        if (!on_vertex_) return;
        const double share =
            (mesh_.point(v) - mesh_.point(a)).norm() / (mesh_.point(b) - mesh_.point(a)).norm();
        on_vertex_({number(v), {{number(a), 1 - share}, {number(b), share}}});
    }

    //! New triangles take over the layers of the one they were part of.
    Vertex split(Edge e, const TriMesh::Point& p) {
        const Halfedge h = mesh_.halfedge_handle(e, 0), o = mesh_.halfedge_handle(e, 1);
        LayerSet left, right;
        Vertex left_corner;
        if (!mesh_.is_boundary(h)) {
            left = present_[index(mesh_.face_handle(h))];
            left_corner = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
        }
        if (!mesh_.is_boundary(o)) right = present_[index(mesh_.face_handle(o))];
        const auto [a, b] = ends(e);
        const Vertex v = add_vertex(p);
        report(v, a, b);
        mesh_.split(e, v);
        for (std::size_t f = present_.size(); f < mesh_.n_faces(); ++f) {
            bool on_left = false;
            for (const Vertex corner : mesh_.fv_range(Face(static_cast<int>(f))))
                on_left |= corner == left_corner;
            present_.push_back(on_left ? left : right);
        }
        return v;
    }

    //! An edge across a present part from one pinch-out line to another: without thickness in the middle, it
    //! would be an edge at which the body touches itself. Edges added by a cut are looked at in turn.
    void cut_chords() {
        for (std::size_t e = 0; e < mesh_.n_edges(); ++e) {
            const Edge edge(static_cast<int>(e));
            const auto [a, b] = ends(edge);
            LayerSet candidates = in_both_faces(edge);
            if (candidates.none()) continue;
            candidates &= zero_at(a);
            if (candidates.none()) continue;
            candidates &= zero_at(b);
            if (candidates.none()) continue;
            const TriMesh::Point middle = mesh_.calc_edge_midpoint(edge);
            if ((candidates & ~layers_on_line_or_beyond(Point2{middle[0], middle[1]})).any())
                split(edge, middle);
        }
    }

    void cut_flat_faces() {
        for (std::size_t f = 0; f < mesh_.n_faces(); ++f) {
            const Face face(static_cast<int>(f));
            LayerSet flat = present_[f];
            for (const Vertex v : mesh_.fv_range(face))
                if (flat.any()) flat &= zero_at(v);
            if (flat.none()) continue;
            const Vertex centre = add_vertex(mesh_.calc_face_centroid(face));
            on_line_.back() &= ~flat;  // a sliver along a line may be on it all over, but for rounding
            const LayerSet layers = present_[f];
            if (on_vertex_) {
                VertexMean mean{number(centre), {}};
                for (const Vertex v : mesh_.fv_range(face)) mean.of.emplace_back(number(v), 1.0 / 3);
                on_vertex_(mean);
            }
            mesh_.split(face, centre);
            present_.resize(mesh_.n_faces(), layers);
        }
    }

    //! The layers whose body would touch itself at v: it has no thickness there, and the triangles around v
    //! that have it form several fans, or one all around, or one with an edge of no thickness inside.
    LayerSet pinched_at(Vertex v) const {
        const LayerSet zero = zero_at(v);
        LayerSet once, twice, somewhere, inner_zero;  // starts of fans of present triangles, walking around v
        for (const Halfedge h : mesh_.voh_range(v)) {
            if (!mesh_.is_boundary(h)) somewhere |= present_[index(mesh_.face_handle(h))];
            const Halfedge o = mesh_.opposite_halfedge_handle(h);
            const LayerSet here = mesh_.is_boundary(h) ? LayerSet() : present_[index(mesh_.face_handle(h))];
            const LayerSet behind = mesh_.is_boundary(o) ? LayerSet() : present_[index(mesh_.face_handle(o))];
            const LayerSet starts = here & ~behind;
            twice |= once & starts;
            once |= starts;
            if ((here & behind & zero).any())
                inner_zero |= here & behind & zero & zero_at(mesh_.to_vertex_handle(h));
        }
        const LayerSet all_around = somewhere & ~once;
        return zero & (twice | all_around | inner_zero);
    }

    bool open_pinched_vertices(bool with_rings) {
        bool any = false;
        const std::size_t count = mesh_.n_vertices();
        for (std::size_t v = 0; v < count; ++v) {
            const Vertex vertex(static_cast<int>(v));
            if (zero_at(vertex).none()) continue;
            const LayerSet pinched = pinched_at(vertex);
            if (pinched.none()) continue;
            any = true;
            if (with_rings)
                open(vertex, pinched);
            else
                leave_out_around(vertex, pinched);
        }
        return any;
    }

    //! One ring around v serves all layers that are opened there.
    void open(Vertex v, const LayerSet& layers) {
        opened_ += layers.count();
        std::vector<Vertex> thick;  // neighbours at which one of the layers has thickness
        for (const Vertex u : mesh_.vv_range(v))
            if ((layers & ~zero_at(u)).any()) thick.push_back(u);
        for (const Vertex u : thick) {
            const TriMesh::Point from = mesh_.point(v), to = mesh_.point(u);
            const Vertex outer =
                split(mesh_.edge_handle(mesh_.find_halfedge(v, u)), from + 2 * opening_ * (to - from));
            split(mesh_.edge_handle(mesh_.find_halfedge(v, outer)), from + opening_ * (to - from));
        }
        leave_out_around(v, layers);
    }

    void leave_out_around(Vertex v, const LayerSet& layers) {
        for (const Face f : mesh_.vf_range(v)) present_[index(f)] &= ~layers;
    }

    TriMesh& mesh_;
    const ThicknessField* field_ = nullptr;
    double opening_;
    std::function<void(const VertexMean&)> on_vertex_;
    LayerSet all_;
    std::vector<LayerSet> present_;  // by face
    std::vector<LayerSet>
        on_line_;  // by vertex: layers whose share there is no more than the rule's fraction
    std::size_t opened_ = 0;
};

}  // namespace

LayerRegions build_layer_regions(PlanMesh& plan, const ThicknessField& field,
                                 const LayerRegionsOptions& options) {
    if (field.layers() > kMaxLayers)
        throw InvalidInput(
            fmt::format("{} layers are more than the {} that one model can hold (merge some units)",
                        field.layers(), kMaxLayers));
    Regions regions(plan, field, options.opening);
    regions.label();
    regions.make_manifold();
    return regions.take();
}

void mend_layer_regions(PlanMesh& plan, LayerRegions& known, std::size_t layers,
                        const LayerRegionsOptions& options) {
    Regions regions(plan, std::move(known), layers, options);
    regions.make_manifold();
    known = regions.take();
}

}  // namespace stratareeb
