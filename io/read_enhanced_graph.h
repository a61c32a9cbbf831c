// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/plane_frame.h"

namespace stratareeb {

struct ReadGraphOptions {
    bool check = true;  // refuse a graph that breaks the conditions of reeb/graph_conditions.h
};

struct EnhancedGraphFile {
    EnhancedReebGraph graph;
    std::string comment;             // empty if there is none
    std::optional<PlaneFrame> axes;  // the graph's x, y and z axes, seen from where its surface belongs
};

//! An enhanced Reeb graph from its JSON text, as docs/graph_format.md has it. `name` stands for the file in messages.
//! An edge may be written from its upper node to its lower one: it is turned over, with its curve. Its contours stand
//! bottom to top either way.
//! \throw InvalidInput with all that is wrong, each with its place, as in `contours[3].points[2]`
EnhancedGraphFile parse_enhanced_graph(std::string_view text, const std::string& name,
                                       const ReadGraphOptions& options = {});

//! The same from a file.
//! \throw IoError if it can't be read
EnhancedReebGraph read_enhanced_graph(const std::filesystem::path& file,
                                      const ReadGraphOptions& options = {});

}  // namespace stratareeb
