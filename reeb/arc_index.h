// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/interval_tree.h"
#include "reeb/level_set.h"
#include "reeb/reeb_graph.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! Contours of single levels by way of the Reeb graph: each arc that spans a level has one contour there. Every arc keeps one
//! monotone path of mesh edges from its upper end down to its lower one, so a level's contours are found in the time of
//! O(log n) an arc found plus their lengths, whatever the size of the mesh. Mesh, field and graph must outlive the index.
class ArcIndex {
 public:
    //! \pre `graph` is reeb_graph(mesh, field), not collapsed or simplified.
    ArcIndex(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph);

    //! Arcs that have a contour at a level, ascending. As in level_sets, a vertex at the level counts as above it: an arc
    //! has one from above its lower node's value up to that of its upper node.
    std::vector<std::uint32_t> arcs_at(double level) const { return spans_.holding(level); }

    //! The contour of an arc at a level, the same points in the same sense as from level_sets (which may start elsewhere).
    //! \pre arcs_at(level) has the arc
    Contour contour(std::uint32_t arc, double level) const;

    //! A half-edge that leads down across the contour of an arc just above a level, from above it to at or below it.
    //! \pre the level is from the lower node's value up to below that of the upper node
    TriMesh::HalfedgeHandle crossed_above(std::uint32_t arc, double level) const;

    //! All contours of a level, by arc. Those that shrink to a point are left out.
    LevelSet level_set(double level) const;

 private:
    using Halfedge = TriMesh::HalfedgeHandle;

    double value(TriMesh::VertexHandle v) const { return field_[static_cast<std::size_t>(v.idx())]; }
    void add_path(const ReebGraph& graph, std::uint32_t arc);
    std::uint32_t highest_below(std::uint32_t vertex) const;
    Halfedge crossed_edge(std::uint32_t arc, double level) const;
    Halfedge step_down(std::uint32_t arc, std::size_t step) const;
    Halfedge first_of_contour(Halfedge crossed, double level) const;

    const TriMesh& mesh_;
    const ScalarField& field_;
    std::vector<std::size_t> first_;   // of each arc in path_
    std::vector<std::uint32_t> path_;  // vertices from each arc's top down
    IntervalTree spans_;
};

}  // namespace stratareeb
