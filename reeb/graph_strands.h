// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! One edge's contours as polygons with parameters by length, bottom to top, and their heights (of a tilted one its mean).
struct GraphStrand {
    std::vector<SampledContour> contours;
    std::vector<double> heights;
};

//! The strands of all edges. Polygons keep their own corners; other curves get `samples` points.
//! \throw InvalidInput if a contour is no curve
std::vector<GraphStrand> strands_of(const EnhancedReebGraph& graph, std::size_t samples);

//! By edge: do its contours bound a hole, the solid lying outside of them? Those of an outer surface and those of a hole in it that join
//! it lie in one another where they meet; a part of the graph on its own is that of a cavity if an odd number of contours of others lie around it
//! (mixed linearly between given ones).
std::vector<bool> hole_edges(const EnhancedReebGraph& graph, const std::vector<GraphStrand>& strands);

}  // namespace stratareeb
