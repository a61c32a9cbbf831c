// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/loop_handles.h"
#include "reeb/persistence.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! What a JSON file holds besides nodes and arcs, if it is there.
struct GraphDetails {
    std::optional<std::vector<PersistencePair>> pairs = {};
    std::optional<std::vector<LoopHandle>> loops = {};
};

//! Write a Reeb graph by the file's extension: .json (see write_graph_json), .dot (GraphViz) or .graphml. Arcs between the same
//! two nodes stay apart in each of them.
//! \throw IoError for another extension, or if the file can't be written
void write_graph(const std::filesystem::path& file, const ReebGraph& graph, const TriMesh& mesh,
                 const GraphDetails& details = {});

//! Does the extension stand for one of these formats?
bool is_graph_file(const std::filesystem::path& file);

//! "minimum", "saddle" or "maximum".
const char* type_name(CriticalType type);

//! The place of a node's vertex.
Point3 node_place(const TriMesh& mesh, const ReebNode& node);

}  // namespace stratareeb
