// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"
#include "reeb/simplify.h"

namespace stratareeb {

struct AskedGraphOptions {
    std::optional<double> simplify;  // share of the field's range, see reeb/simplify.h
    bool plateaus = false;           // each plateau as one node
};

//! A mesh's Reeb graph, with what was asked for.
struct AskedGraph {
    ReebGraph fine, collapsed;  // ties broken by vertex index; each plateau as one node
    std::optional<SimplifiedGraph> simplified;
    bool plateaus = false;
    double seconds = 0;  // that `fine` took

    const ReebGraph& graph() const { return simplified ? simplified->graph : plateaus ? collapsed : fine; }
};

AskedGraph asked_graph(const TriMesh& mesh, const ScalarField& field, const AskedGraphOptions& options);

//! What `reeb` tells of one mesh, for programs: counts of the mesh, of the graph and of the critical points.
nlohmann::ordered_json reeb_json(const TriMesh& mesh, const ScalarField& field, const AskedGraph& asked);

//! The same for people, several lines.
std::string reeb_text(const TriMesh& mesh, const ScalarField& field, const AskedGraph& asked);

//! "1 node", "2 nodes".
std::string counted(std::size_t count, const char* thing);

}  // namespace stratareeb
