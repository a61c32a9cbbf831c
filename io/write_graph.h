// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Write a Reeb graph by the file's extension: .json (nodes with vertex, position, value and type; arcs as pairs of nodes),
//! .dot (GraphViz) or .graphml.
//! \throw IoError for another extension, or if the file can't be written
void write_graph(const std::filesystem::path& file, const ReebGraph& graph, const TriMesh& mesh);

//! "minimum", "saddle" or "maximum".
const char* type_name(CriticalType type);

}  // namespace stratareeb
