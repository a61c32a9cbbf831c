// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Write a Reeb graph as lines in space, .ply or .obj. Points 0 … nodes - 1 are the nodes (PLY: in the colour of their type, see
//! node_color), then come the inner points of each arc's curve (in the colour of the arc). PLY: `edge` elements {int vertex1, vertex2,
//! int arc}; OBJ: one `l` an arc, from its lower node to its upper one. So arcs between the same nodes stay apart.
//! \param curves one an arc, from node to node, as arc_curves makes them
//! \throw IoError for another extension, or if the file can't be written; InvalidInput if the curves don't fit the graph
void write_graph_lines(const std::filesystem::path& file, const ReebGraph& graph, const TriMesh& mesh,
                       std::span<const std::vector<Point3>> curves);

//! Does the extension stand for one of these formats?
bool is_graph_lines_file(const std::filesystem::path& file);

}  // namespace stratareeb
