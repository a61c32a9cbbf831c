// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! A Reeb graph that people can read, and the whole one it was made from.
struct ReadableGraph {
    ReebGraph fine, graph;
    double share =
        0;  // of the field's range below which features were left out; 0 = plateaus were made one node, no more
};

//! Each plateau as one node, then simplified by ever larger shares of the field's range (0.5 % to 20 %) until there are at most
//! `most_nodes`, or no larger share is left to try.
ReadableGraph readable_graph(const TriMesh& mesh, const ScalarField& field, std::size_t most_nodes);

}  // namespace stratareeb
