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

//! Cancel what is less persistent (see reeb/persistence.h) than this share of the field's range over the graph. Branches are
//! pruned; what has grown on a branch moves over to the one it joined, and stays at its height. Loops are closed by
//! gluing their sides, equal values to equal values. Nodes left with one arc down and one up vanish.
//!
//! The result is a Reeb graph with the same components and hidden loops; all its pairs but the components' reach the
//! threshold. They are the old pairs that did, node by node, if each loop that is closed has two sides that rise all the way when
//! its turn comes (the least persistent first): so in every graph without loops, and wherever no loop is as short as
//! that. To close a loop whose sides must sink on their way up, these rises are glued first: then nodes of other pairs may
//! change too, and pairs that come to be below the threshold are cancelled as well.
//!
//! A vertex stays at its height: it goes to the arc that its old arc became there. A vertex on a branch that was pruned
//! goes to an arc at the branch's root, less than the threshold away where there are no loops. An arc may have several
//! contours at one height, so look for contours in the old graph. Time: that of the pairs, and the number of nodes passed
//! on trunks by branches that others have grown on, and on the sides of loops: near-linear on terrain and on plates with
//! holes, quadratic at worst.
//! \return a graph without the arcs of triangles, for which the mesh is needed: see below.
//! \throw InvalidInput unless 0 <= relative_persistence < 1, or if the field has not a value for each vertex of the graph.
SimplifiedGraph simplify(const ReebGraph& graph, const ScalarField& field, double relative_persistence);

//! The same, with the arc of each triangle of the mesh.
SimplifiedGraph simplify(const ReebGraph& graph, const TriMesh& mesh, const ScalarField& field,
                         double relative_persistence);

}  // namespace stratareeb
