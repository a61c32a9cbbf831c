// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/read_contour_stack.h"
#include "reeb/graph_of_stack.h"
#include "reeb/plane_frame.h"

namespace stratareeb {

//! A file of an enhanced Reeb graph, or of a contour stack with the graph that was found in it.
struct ReconstructInput {
    EnhancedReebGraph graph;
    std::optional<StackGraph> stack;  // its graph has moved to `graph`; nothing if the file was a graph
    std::optional<PlaneFrame> axes;   // of a graph that was turned: see EnhancedGraphFile
    std::vector<std::string>
        sources;  // of a stack, by contour of the graph: what the file calls it, and its height
};

//! For each contour that a message calls "contour ID": a line that says which one of the file that is.
std::string contours_named_in(const std::string& message, const ReconstructInput& input);

struct StackOptions {
    ReadContourStackOptions read;
    StackGraphOptions graph;
};

//! The options that say how a contour stack is read and what its ends are like; \see refuse_stack_options.
void add_stack_options(CLI::App& command, StackOptions& options);

//! Is the file's content a JSON object with nodes or edges?
//! \throw IoError if it can't be read, InvalidInput if it is a Reeb graph without contours
bool is_enhanced_graph_file(const std::string& file);

//! \throw InvalidInput, IoError with the file's name
ReconstructInput read_reconstruct_input(const std::string& file, const StackOptions& options);

//! \throw CLI::ValidationError for the first option given that is about contour stacks
void refuse_stack_options(const CLI::App& command);

}  // namespace stratareeb
