// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "reeb/layered_reeb_graph.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Write a layered Reeb graph by the file's extension: .json (`layers`: names; `nodes` with id, value, center and their `contours`:
//! layer, arc of the layer's own Reeb graph, center, closed, points [x, y, z]; `arcs`: from, to, layer), .dot (GraphViz, layers by
//! colour) or .obj (each layer a group: its contours, and its arcs as lines between the nodes' centres).
//! \param layers a name for each layer
//! \throw IoError for another extension, or if the file can't be written
void write_layered_graph(const std::filesystem::path& file, const LayeredReebGraph& graph,
                         std::span<const std::string> layers);

}  // namespace stratareeb
