// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/horizon_deviation.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! The plan of a layer model while vertices are taken out of it: which may go, into which neighbour, how far horizons are
//! off then. Faces and vertices keep their numbers; deleted ones are marked.
class PlanCollapse {
 public:
    using Vertex = TriMesh::VertexHandle;
    using Edge = TriMesh::EdgeHandle;
    using Halfedge = TriMesh::HalfedgeHandle;
    using Face = TriMesh::FaceHandle;

    struct Limits {
        double line_tolerance = 0;     // how far pinch-out lines may be straightened, in plan
        double outline_tolerance = 0;  // what counts as straight of the outline
        double min_sine = 0;           // of the angles of new triangles
        double deviation = 0;
    };

    struct Choice {
        Halfedge into;         // from the vertex to the neighbour that takes its place
        double deviation = 0;  // of any horizon, anywhere in the triangles that change
        double length = 0;     // of the edge
        double sine = 0;       // of the smallest angle of new triangles
    };

    //! \pre the model outlives this
    PlanCollapse(const LayerModel& model, const Limits& limits);

    //! The best way to take v out; empty if there is none within the limits.
    std::optional<Choice> best(Vertex v);
    //! The same with the neighbour given.
    std::optional<Choice> try_into(Halfedge into);

    //! Take the vertex out. \pre try_into(into) found a way
    void collapse(Halfedge into);

    //! Turn the edge from v that can be turned best, so that v has one edge less. False if none can be within the limits.
    //! A vertex that can't be taken out often can then.
    bool turn_edge_away(Vertex v);

    const TriMesh& mesh() const { return mesh_; }
    std::size_t triangles() const { return triangles_; }

    //! The largest deviation of all that is left, measured anew.
    double deviation() const;

 private:
    using Corners = std::array<Vertex, 3>;
    static constexpr std::uint32_t kNone = ~0u;

    //! The edges around a vertex that are part of a line: the outline, or one where layers end.
    std::vector<Halfedge> lines_at(Vertex v) const;
    bool is_line(Halfedge h) const;
    std::uint32_t label(Face f) const { return label_[static_cast<std::size_t>(f.idx())]; }

    std::optional<Choice> examine(Halfedge into, const std::vector<Halfedge>& lines, double deviation_limit);
    bool keeps_lines(Halfedge into, const std::vector<Halfedge>& lines) const;
    bool keeps_thickness(Halfedge into) const;
    bool is_new_edge(Halfedge h, Vertex kept) const;
    bool is_zero_triangle(Face f, const Corners& corners) const;
    std::optional<double> new_sine(Halfedge into) const;
    double new_deviation(Halfedge into, double limit) const;
    std::vector<Corners> fan_of(Halfedge into, std::vector<Face>* faces = nullptr) const;
    std::size_t place_in(const std::vector<Corners>& fan, Vertex p) const;
    Corners corners_of(Face f) const;
    bool is_unfolded(const Corners& triangle) const;
    double sine_of(const Corners& triangle) const;  // of the smallest angle

    struct Turn {  // of an edge inside of two triangles
        std::array<Face, 2> faces;
        std::array<Corners, 2> after;
    };
    std::optional<Turn> turn_of(Halfedge h) const;
    bool is_within_limits(const Turn& turn) const;
    void turn(Halfedge h, const Turn& turn);

    const LayerModel& model_;
    Limits limits_;
    HorizonDeviation before_;
    TriMesh mesh_;
    std::size_t triangles_;
    std::vector<char> fixed_;
    std::vector<std::uint32_t> label_;  // of each face: the same number, the same layers
    // Removed vertices, as lists: of the triangle that they lie in now, of the line that stands for theirs.
    std::vector<std::uint32_t> first_in_face_, next_in_face_, first_on_line_, next_on_line_;
};

}  // namespace stratareeb
