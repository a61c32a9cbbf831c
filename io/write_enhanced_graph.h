// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/plane_frame.h"

namespace stratareeb {

//! An enhanced Reeb graph as JSON, as docs/graph_format.md has it, a node, contour or edge a line. Every number reads back
//! as the same double. Left out are parameters that don't count for a curve's kind, and a homotopy that is the default.
//! \param axes the graph's x, y and z axes, if it was turned
//! \throw InvalidInput if the graph can't stand in a file: names that are not unique or not UTF-8, numbers that are not
//! finite, edges of nodes or contours that are not there, edges' curves of other kinds than lines and splines
std::string enhanced_graph_text(const EnhancedReebGraph& graph, std::string_view comment = {},
                                const std::optional<PlaneFrame>& axes = std::nullopt);

//! The same into a file.
//! \throw IoError if it can't be written; the old file stays
void write_enhanced_graph(const std::filesystem::path& file, const EnhancedReebGraph& graph,
                          std::string_view comment = {},
                          const std::optional<PlaneFrame>& axes = std::nullopt);

}  // namespace stratareeb
