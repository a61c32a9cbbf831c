// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "io/write_graph.h"

namespace stratareeb {

//! A Reeb graph as JSON: `nodes` {id, vertex, position, value, type, down, up: numbers of arcs}, `arcs` {from, to, vertices,
//! triangles: how many the arc has}. With details, `pairs` {kind: join|split|loop|component, lower, upper, persistence} and `loops`
//! {nodes: [lower, upper], persistence, arcs: two ways from the one to the other, triangles: how many the handle has, box: [min, max]}.
void write_graph_json(std::ostream& stream, const ReebGraph& graph, const TriMesh& mesh,
                      const GraphDetails& details);

//! "join", "split", "loop" or "component".
const char* kind_name(PairKind kind);

}  // namespace stratareeb
