// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reeb/band_surface.h"
#include "reeb/strand_surface.h"
#include "reeb/surface_construction.h"

namespace stratareeb {

//! One side of a node: edges that end there, or start there.
struct NodeSide {
    const std::vector<std::uint32_t>& edges;
    bool is_lower;
};

//! What strands are where they come to that side of a node.
StrandEnd& end_of(std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge);
SampledContour& end_contour(std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge);
double end_height(const std::vector<Strand>& strands, const NodeSide& side, std::uint32_t edge);

//! A node as messages name it, and where it is.
struct NamedNode {
    std::string name;
    Point3 place;
};

//! Lead the contours of one side of a saddle to it by guiding curves (thesis 2.1.2.3.3), or pass through it with them if they
//! do already; what they make of one another there goes on in the strands of the other side. Sets the ends of all strands there.
//! \throw InvalidInput if they don't make as many contours as the other side has: it names the node and the way out
void make_saddle(const NamedNode& node, const NodeSide& lower, const NodeSide& upper,
                 const SurfaceOptions& options, std::vector<Strand>& strands, BandSurface& surface);

}  // namespace stratareeb
