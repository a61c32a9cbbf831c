// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

struct SimplifiedGraph {
    ReebGraph graph;
    double threshold = 0;             // persistence below which pairs were cancelled, in units of the field
    std::size_t pruned_branches = 0;  // pairs Join and Split that were cancelled
    std::size_t closed_loops = 0;     // pairs Loop that were cancelled; loops() is less by their number
};

//! Cancel what is less persistent (see reeb/persistence.h) than this share of the field's range over the graph. Branches are pruned;
//! where others have grown on a branch, it is glued to the one it joins, equal values to equal values, so that those stay
//! at their heights. Loops are closed by gluing their sides. Nodes left with one arc down and one up vanish.
//!
//! The result is a Reeb graph with the same components and hidden loops, whose pairs all reach the threshold. Pairs Join, Split and Component that
//! do are those of the old graph, and so are the loops, as long as each loop that is closed has two sides that rise all the way when
//! its turn comes (shortest first). So it is for all graphs without loops. Else the ends of other pairs may move by less than the
//! threshold for each such loop, and pairs that fall below it are cancelled too.
//!
//! A vertex goes to the arc that took its point of the old graph in, whose range has the vertex's value; on a pruned leaf, to an arc at the
//! leaf's root. Triangles are left without arcs: see below. An arc may have several contours at one height: look for contours
//! in the old graph. Time: O(n log n), and the number of nodes passed where branches and loops are glued.
//! \throw InvalidInput unless 0 <= relative_persistence < 1, or if the field has not a value for each vertex of the graph.
SimplifiedGraph simplify(const ReebGraph& graph, const ScalarField& field, double relative_persistence);

//! The same, with the arc of each triangle of the mesh.
SimplifiedGraph simplify(const ReebGraph& graph, const TriMesh& mesh, const ScalarField& field,
                         double relative_persistence);

}  // namespace stratareeb
