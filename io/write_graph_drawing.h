// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "boreholes/point.h"
#include "reeb/arc_members.h"

namespace stratareeb {

//! What is drawn: a surface's contours, which come from its Reeb graph and index, and a graph beside them: the same one or a
//! coarser one (plateaus collapsed, simplified).
struct DrawnGraph {
    const TriMesh& mesh;
    const ScalarField& field;
    const ReebGraph& fine;      // reeb_graph(mesh, field)
    const ArcIndex& index;      // of it
    const ReebGraph& graph;     // to be drawn
    const ArcMembers& members;  // arc_members(fine, graph)
};

struct GraphDrawingOptions {
    std::string title = {};
    std::string value_label = "z";                  // beside the axis
    std::optional<Point3> direction = {{0, 0, 1}};  // in which the field is height; none = it is not
    std::size_t levels = 25;                        // contours are drawn at so many, evenly
    std::size_t most_nodes = 2000;                  // more are refused: nobody could read the drawing
};

//! Draw a Reeb graph beside its levels, .svg, .pdf or .png: on the left the contours in a side view from slightly above, on the right
//! the graph, over one axis of values. Contours and arcs have the same colours (see arc_colors), nodes those of their type. The
//! same input gives the same bytes (with the same fonts installed; SVG: in a program's first drawing).
//! \throw IoError for another extension or if the file can't be written; InvalidInput if the graph has no nodes or too many
void write_graph_drawing(const std::filesystem::path& file, const DrawnGraph& drawn,
                         const GraphDrawingOptions& options = {});

}  // namespace stratareeb
